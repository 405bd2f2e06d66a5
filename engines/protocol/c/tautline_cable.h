// A case, the geometry of its cables, and the numbers of a message. A state is x y angle vx vy
// spin.
#pragma once
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { tautline_most_cables = 8 };
typedef struct {
  double anchor[2], attachment[2], length;
  const json_t* restitution;
} tautline_cable;
typedef struct {  // lives until the next start; `state` is the first
  double mass, inertia, gravity[2], state[6];
  int cables;
  tautline_cable cable[tautline_most_cables];
} tautline_case;

// A cable as a one-sided row: an impulse along (nx, ny) at (px, py) raises its gap rate [m/s],
// which is negative when closing. The gap's gradient is (nx, ny, moment).
typedef struct {
  double px, py, nx, ny, moment, gap, rate;
} tautline_row;

// A text stands for a number that JSON has none for.
static double tautline_number(const json_t* value) {
  return json_is_string(value) ? strtod(json_string_value(value), NULL) : json_number_value(value);
}
static void tautline_read(const json_t* array, int count, double* to) {
  for (int k = 0; k < count; ++k) to[k] = tautline_number(json_array_get(array, k));
}
static json_t* tautline_add(json_t* array, const double* from, int count) {
  for (int k = 0; k < count; ++k) {
    const char* text = isnan(from[k]) ? "NaN" : from[k] > 0 ? "Infinity" : "-Infinity";
    json_array_append_new(array, isfinite(from[k]) ? json_real(from[k]) : json_string(text));
  }
  return array;
}

static tautline_row tautline_row_of(const tautline_cable* cable, const double* q) {
  const double c = cos(q[2]), s = sin(q[2]), *a = cable->attachment;
  const double rx = c * a[0] - s * a[1], ry = s * a[0] + c * a[1];  // [m], the arm
  const double dx = cable->anchor[0] - q[0] - rx, dy = cable->anchor[1] - q[1] - ry,
               far = hypot(dx, dy);
  const double nx = far > 0 ? dx / far : 0, ny = far > 0 ? dy / far : 0, m = rx * ny - ry * nx;
  return (tautline_row){
      q[0] + rx, q[1] + ry, nx, ny, m, cable->length - far, nx * q[3] + ny * q[4] + m * q[5]};
}

// The restitution [-] of a cable whose gap closes at `rate` [m/s]: a number, or a table over speed.
static inline double tautline_restitution(const tautline_cable* cable, double rate) {
  const size_t count = json_array_size(cable->restitution);  // 0 for a number
  double last[2], next[2] = {0, json_number_value(cable->restitution)};
  for (size_t k = 0; k < count; ++k) {
    memcpy(last, next, sizeof last);
    tautline_read(json_array_get(cable->restitution, k), 2, next);
    if (fabs(rate) < next[0])
      return k ? last[1] + (fabs(rate) - last[0]) / (next[0] - last[0]) * (next[1] - last[1])
               : next[1];
  }
  return next[1];
}

static tautline_case tautline_case_of(json_t* from) {
  tautline_case c = {0};
  json_t *position = NULL, *velocity = NULL, *angle = NULL, *spin = NULL, *cables = NULL, *row;
  json_unpack(from, "{s:{s:F, s:F}, s:[FF], s:{s:o, s:o, s:o, s:o}, s:o}", "body", "mass", &c.mass,
              "inertia", &c.inertia, "gravity", &c.gravity[0], &c.gravity[1], "initial", "position",
              &position, "angle", &angle, "velocity", &velocity, "spin", &spin, "cables", &cables);
  tautline_read(position, 2, c.state);
  tautline_read(velocity, 2, c.state + 3);
  c.state[2] = tautline_number(angle);
  c.state[5] = tautline_number(spin);
  while (c.cables < tautline_most_cables && (row = json_array_get(cables, c.cables))) {
    tautline_cable* k = &c.cable[c.cables++];
    json_unpack(row, "{s:[FF], s:[FF], s:F, s:o}", "anchor", &k->anchor[0], &k->anchor[1],
                "attachment", &k->attachment[0], &k->attachment[1], "length", &k->length,
                "restitution", &k->restitution);
  }
  return c;
}
