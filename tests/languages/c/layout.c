/* The layout of the structs of version 0.1, asserted by a compiler of C99. Other languages write it
 * down, so no member may ever move. */
#include <tautline/tautline.h>

/* a typedef of an array that cannot be where the claim is false */
#define CLAIM(name, claim) typedef char name[(claim) ? 1 : -1]
#define SIZE(type, bytes) CLAIM(type##_bytes, sizeof(type) == (bytes))
#define AT(type, member, bytes) CLAIM(type##_##member, offsetof(type, member) == (bytes))

SIZE(tautline_cable, 72);
AT(tautline_cable, size, 0);
AT(tautline_cable, taut, 4);
AT(tautline_cable, anchor, 8);
AT(tautline_cable, attachment, 24);
AT(tautline_cable, length, 40);
AT(tautline_cable, restitution, 48);
AT(tautline_cable, capture_speed, 56);
AT(tautline_cable, table_points, 64);
AT(tautline_cable, reserved, 68);

SIZE(tautline_planar_case, 112);
AT(tautline_planar_case, size, 0);
AT(tautline_planar_case, has, 4);
AT(tautline_planar_case, mass, 8);
AT(tautline_planar_case, inertia, 16);
AT(tautline_planar_case, gravity, 24);
AT(tautline_planar_case, start, 40);
AT(tautline_planar_case, duration, 88);
AT(tautline_planar_case, angle_limit, 96);
AT(tautline_planar_case, ceiling, 104);

SIZE(tautline_options, 48);
AT(tautline_options, size, 0);
AT(tautline_options, law, 4);
AT(tautline_options, completion_error, 8);
AT(tautline_options, completion_speed, 16);
AT(tautline_options, completion_margin, 24);
AT(tautline_options, max_events, 32);
AT(tautline_options, max_steps, 36);
AT(tautline_options, until_locked, 40);
AT(tautline_options, swing_ahead, 44);

SIZE(tautline_summary, 80);
AT(tautline_summary, size, 0);
AT(tautline_summary, status, 4);
AT(tautline_summary, ending, 8);
AT(tautline_summary, taut, 12);
AT(tautline_summary, events, 16);
AT(tautline_summary, impacts, 20);
AT(tautline_summary, arcs, 24);
AT(tautline_summary, accumulations, 28);
AT(tautline_summary, end_time, 32);
AT(tautline_summary, start_energy, 40);
AT(tautline_summary, end_energy, 48);
AT(tautline_summary, repeat_start, 56);
AT(tautline_summary, repeat_period, 64);
AT(tautline_summary, repeat_turn, 72);

SIZE(tautline_settling, 128);
AT(tautline_settling, size, 0);
AT(tautline_settling, cables, 4);
AT(tautline_settling, permanent, 8);
AT(tautline_settling, rests, 12);
AT(tautline_settling, swings, 16);
AT(tautline_settling, goes_round, 20);
AT(tautline_settling, angle_of_cable, 24);
AT(tautline_settling, reserved, 28);
AT(tautline_settling, time, 32);
AT(tautline_settling, uncertainty, 40);
AT(tautline_settling, last_impact_speed, 48);
AT(tautline_settling, last_impact_time, 64);
AT(tautline_settling, swing_energy, 80);
AT(tautline_settling, swing_period, 88);
AT(tautline_settling, swing_least, 96);
AT(tautline_settling, swing_largest, 104);
AT(tautline_settling, swing_amplitude, 112);
AT(tautline_settling, swing_tension, 120);
