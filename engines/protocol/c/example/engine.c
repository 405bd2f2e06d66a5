/* A planar body in semi-implicit Euler, with a row for each overstretched cable. Your engine steps in its place. */
#include "tautline_engine.h"

typedef struct {
  const tautline_case *the_case;
  double state[6], inverse[3], correction;
} body;

static const double correction = 0.2; /* [-], the part of an overstretch that a step takes out */
static const double rounding = 1e-15; /* [m/s], what sweeps over the rows may leave of a rate */
static const int most_sweeps = 10000;

static void *start(const tautline_case *the_case, double step, const char *law, const char **why) {
  body *b = malloc(sizeof *b);
  (void)law, (void)why;
  b->the_case = the_case;
  b->inverse[0] = b->inverse[1] = 1 / the_case->mass;
  b->inverse[2] = the_case->inertia > 0 ? 1 / the_case->inertia : 0;
  b->correction = correction / step;
  memcpy(b->state, the_case->state, sizeof b->state);
  return b;
}

static void state(void *run, double to[6]) { memcpy(to, ((body *)run)->state, 6 * sizeof *to); }

/* Brings a row to its wanted rate by an impulse that is not below 0 in all; returns the change of rate. */
static double pull(body *b, tautline_row row, double wanted, double *impulse) {
  const double gradient[] = {row.nx, row.ny, row.moment}, before = *impulse;
  double response = 0, rate = 0;
  for (int k = 0; k < 3; ++k) response += b->inverse[k] * gradient[k] * gradient[k], rate += gradient[k] * b->state[3 + k];
  *impulse = fmax(0, before + (wanted - rate) / response);
  for (int k = 0; k < 3; ++k) b->state[3 + k] += b->inverse[k] * gradient[k] * (*impulse - before);
  return fabs(*impulse - before) * response;
}

static void step(void *run, double dt, double *impulses) {
  body *b = run;
  tautline_row rows[tautline_most_cables];
  double wanted[tautline_most_cables], change = 1;
  const int count = b->the_case->cables;
  for (int k = 0; k < count; ++k) {
    const tautline_row row = rows[k] = tautline_row_of(&b->the_case->cable[k], b->state);
    wanted[k] = fmax(-row.rate * tautline_restitution(&b->the_case->cable[k], row.rate), -b->correction * row.gap);
    impulses[k] = 0;
  }
  for (int k = 0; k < 2; ++k) b->state[3 + k] += dt * b->the_case->gravity[k];
  for (int sweep = 0; sweep < most_sweeps && change > rounding; ++sweep) {
    change = 0;
    for (int k = 0; k < count; ++k)
      if (rows[k].gap <= 0) change = fmax(change, pull(b, rows[k], wanted[k], &impulses[k]));
  }
  for (int k = 0; k < 3; ++k) b->state[k] += dt * b->state[3 + k];
}

int main(void) {
  const char *row = "{\"name\": \"row\", \"sentence\": \"One row for each cable that is at its length.\","
                    " \"maker\": \"by_hand\", \"follows_speed\": true, \"settings\": []}";
  const tautline_model models[] = {{.name = "row", .info = row, .start = start, .state = state, .step = step, .end = free}};
  return tautline_serve("{\"name\": \"c-example\", \"version\": \"1.0\", \"precision\": \"float64\"}", models, 1);
}
