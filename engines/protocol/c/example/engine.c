// A planar body in semi-implicit Euler, with a row for each overstretched cable.
#include "tautline_engine.h"

typedef struct {
  const tautline_case* the_case;
  double state[6], inverse[3], correction;
} body;

static void* start(const tautline_case* the_case, double step, const char* law, const char** why) {
  const double mass = the_case->mass, inertia = the_case->inertia;
  const double part = 0.2;  // [-], of an overstretch, that a step takes out
  body made = {the_case, {0}, {1 / mass, 1 / mass, inertia > 0 ? 1 / inertia : 0}, part / step};
  (void)law, (void)why;
  memcpy(made.state, the_case->state, sizeof made.state);
  return memcpy(malloc(sizeof made), &made, sizeof made);
}

static void state(void* run, double to[6]) { memcpy(to, ((body*)run)->state, 6 * sizeof *to); }

// Brings a row to its wanted rate by an impulse that is never below 0; the change of rate [m/s].
static double pull(body* b, tautline_row row, double wanted, double* impulse) {
  const double gradient[] = {row.nx, row.ny, row.moment}, before = *impulse;
  double response = 0, rate = 0;
  for (int k = 0; k < 3; ++k) response += b->inverse[k] * gradient[k] * gradient[k];
  for (int k = 0; k < 3; ++k) rate += gradient[k] * b->state[3 + k];
  *impulse = fmax(0, before + (wanted - rate) / response);
  for (int k = 0; k < 3; ++k) b->state[3 + k] += b->inverse[k] * gradient[k] * (*impulse - before);
  return fabs(*impulse - before) * response;
}

static void step(void* run, double dt, double* impulses) {
  body* b = run;
  tautline_row rows[tautline_most_cables];
  double wanted[tautline_most_cables], change = 1;
  const int count = b->the_case->cables, most_sweeps = 10000;
  for (int k = 0; k < count; ++k) {
    const tautline_cable* cable = &b->the_case->cable[k];
    rows[k] = tautline_row_of(cable, b->state);
    wanted[k] = fmax(-rows[k].rate * tautline_restitution(cable, rows[k].rate),
                     -b->correction * rows[k].gap);
    impulses[k] = 0;
  }
  for (int k = 0; k < 2; ++k) b->state[3 + k] += dt * b->the_case->gravity[k];
  for (int sweep = 0; sweep < most_sweeps && change > 1e-15; ++sweep) {  // [m/s], rounding
    change = 0;
    for (int k = 0; k < count; ++k)
      if (rows[k].gap <= 0) change = fmax(change, pull(b, rows[k], wanted[k], &impulses[k]));
  }
  for (int k = 0; k < 3; ++k) b->state[k] += dt * b->state[3 + k];
}

int main(void) {
  const char* info = "{\"name\": \"c-example\", \"version\": \"1.0\", \"precision\": \"float64\"}";
  const char* row =
      "{\"name\": \"row\", \"sentence\": \"One row for each overstretched cable.\","
      " \"maker\": \"by_hand\", \"follows_speed\": true, \"tension\": true, \"settings\": []}";
  const tautline_model model = {"row", row, start, state, step, NULL, NULL, NULL, free};
  return tautline_serve(info, &model, 1);
}
