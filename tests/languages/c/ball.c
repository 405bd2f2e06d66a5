/* The bouncing ball in C99: each impact comes after half the time of the one before. */
#include <stdio.h>
#include <tautline/tautline.h>

int main(void) {
  tautline_planar_case ball = {0};
  tautline_cable cable = {0};
  ball.size = sizeof ball;
  ball.mass = 1.0;
  ball.inertia = 0.4;
  ball.gravity[1] = -1.0;
  ball.start[1] = 0.5;
  ball.duration = 10.0;
  cable.size = sizeof cable;
  cable.anchor[1] = 2.0;
  cable.length = 2.0;
  cable.restitution = 0.5;

  tautline_case* the_case = tautline_case_from_numbers(&ball, &cable, 1, NULL, 0, "ball");
  tautline_motion* motion = NULL;
  double time[4], impulse[4], state[6];
  const double at = 1.5;
  tautline_settling settling = {0};
  settling.size = sizeof settling;
  const int called =
      tautline_solve(the_case, NULL, &motion) == TAUTLINE_OK &&
      tautline_events(motion, 0, 4, time, NULL, NULL, NULL, NULL, impulse) == TAUTLINE_OK &&
      tautline_states(motion, &at, 1, state, NULL, NULL) == TAUTLINE_OK &&
      tautline_settle(motion, &settling) == TAUTLINE_OK;
  /* dyadic numbers: nothing is rounded */
  const int right = called && time[0] == 1.0 && time[1] == 2.0 && time[2] == 2.5 && time[3] == 2.75 &&
                    impulse[0] == 1.5 && impulse[3] == 0.1875 && state[1] == 0.125 && state[4] == 0.0 &&
                    settling.time == 3.0 && settling.rests == 1 && settling.cables == 1;
  printf("%s\n", right ? "right" : "wrong");
  tautline_motion_free(motion);
  tautline_case_free(the_case);
  return right ? 0 : 1;
}
