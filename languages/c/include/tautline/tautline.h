/* The exact motion of rigid bodies on slack cables, for C and for every language that can call C.
 *
 *   tautline_case* ball = tautline_case_from_text(text, strlen(text), "ball.toml");
 *   tautline_motion* motion = NULL;
 *   if (tautline_solve(ball, NULL, &motion) == TAUTLINE_OK) { ... tautline_states(motion, ...); }
 *   tautline_motion_free(motion);
 *   tautline_case_free(ball);
 *
 * A case is one system, its start and its duration. A motion is its exact solution. Both are
 * opaque: a later kind of case, with more bodies or in space, comes in as text and needs no other
 * function. States are rows of doubles. tautline_coordinates gives their width, and the name and
 * the unit of each column.
 *
 * Rules for all functions
 * - A function that can fail returns TAUTLINE_OK or another tautline_status. It then has written
 *   nothing, unless its comment says more; if memory is missing, some rows may have been written.
 * - No argument ends the program: not null, NaN, a wrong size or missing memory. A pointer must be
 *   null or point to as much as the comment says.
 * - Arrays belong to the caller. An output array that is null is skipped. Arrays have one row for
 * each event, time or case, one after the other. A count of 0 takes null pointers.
 * - Text goes into the caller's `room` bytes and always ends with a zero byte if `room` > 0. The
 *   function returns the length of the whole text [bytes], without the zero byte, as snprintf does:
 *   it was cut if that is `room` or more. Null with `room` 0 asks for the length.
 * - Constant strings (names, units) stay valid as long as the library, those of a case as long as
 * it.
 * - Nothing is global. A case and a motion do not change: several threads may use one at a time.
 *   Free each once, after its last use; null is accepted. A motion outlives its case.
 * - Same input, same bits, also in several threads.
 * - A set of cables is an int32 with bit i for cable i, from 0. No case has more than 31.
 * - "None" is NaN where a number may be missing.
 *
 * How structs grow
 * Each struct has the same layout everywhere: int32 and double alone, without hidden padding. Its
 * first member `size` is sizeof of the struct, set by the caller, for outputs too. A later version
 * adds members at the end only, and 0 means for each of them what the library did before.
 * - A smaller size than the library's (an older program): the library takes 0 for the missing
 * members and does not write them. A size below that of the first version is refused.
 * - A larger size (an older library): the members that it does not know must be 0; outputs get 0
 * there.
 * - An array of structs steps by the size that its first one has; that of the others is not read.
 *
 * Units are in brackets. Lengths, masses and times may also be without units: gravity decides.
 */
#ifndef TAUTLINE_TAUTLINE_H
#define TAUTLINE_TAUTLINE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define TAUTLINE_API __attribute__((visibility("default")))
#else
#define TAUTLINE_API
#endif

/* The version of this header. Before 1.0 a minor version may break what was compiled before. */
#define TAUTLINE_VERSION_MAJOR 0
#define TAUTLINE_VERSION_MINOR 1
#define TAUTLINE_VERSION_PATCH 0
#define TAUTLINE_VERSION_NUMBER \
  (TAUTLINE_VERSION_MAJOR * 10000 + TAUTLINE_VERSION_MINOR * 100 + TAUTLINE_VERSION_PATCH)

#define TAUTLINE_MOST_CABLES 8 /* of a case */

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Names ---- */

/* The result of a function: int32. */
enum tautline_status {
  TAUTLINE_OK = 0,
  TAUTLINE_NULL = 1,          /* an argument must not be null */
  TAUTLINE_BAD_SIZE = 2,      /* the `size` of a struct other than the options is not right, or its
                                 unknown part is not 0 */
  TAUTLINE_BAD_CASE = 3,      /* the case has problems: tautline_problems names them */
  TAUTLINE_BAD_OPTION = 4,    /* see tautline_option_problems; or a format that is unknown */
  TAUTLINE_BAD_TIME = 5,      /* a time is NaN, below 0 or after the end of the motion */
  TAUTLINE_BAD_RANGE = 6,     /* the rows are not all there, or no memory could hold as many */
  TAUTLINE_UNKNOWN_NAME = 7,  /* no number of the case has this name */
  TAUTLINE_BAD_THREADS = 8,   /* the number of threads is below 0 */
  TAUTLINE_OUT_OF_MEMORY = 9, /* memory is missing; nothing is lost, and the call may be repeated */
  TAUTLINE_BROKEN = 10        /* a mistake of the library: please report it */
};

/* How impacts that involve several cables are resolved: int32. */
enum tautline_law {
  TAUTLINE_SIMULTANEOUS = 0, /* Moreau's form of Newton's law */
  TAUTLINE_POISSON = 1,      /* restitution of impulses */
  TAUTLINE_SEQUENTIAL = 2,   /* one cable after the other */
  TAUTLINE_ENERGETIC = 3     /* Stronge's: restitution of energy */
};

/* What happens at an event: int32. */
enum tautline_event_kind {
  TAUTLINE_IMPACT = 0, /* a velocity jump: cables closed and rebound */
  TAUTLINE_TAUT = 1,   /* cables at zero gap stay there, held by tension */
  TAUTLINE_SLACK = 2   /* the tension of a taut cable fell to zero */
};

/* Why a motion ends: int32. */
enum tautline_ending {
  TAUTLINE_REACHED_DURATION = 0,
  TAUTLINE_REST = 1, /* the body rests from then on, or spins about the centre it hangs at */
  TAUTLINE_UNSTABLE_REST = 2, /* the same, at an equilibrium that the smallest push ends */
  TAUTLINE_LOCKED = 3,        /* the body swings on its taut cables for ever: see `until_locked` */
  TAUTLINE_ANGLE_LIMIT = 4,   /* |angle| reached the limit of the case */
  TAUTLINE_CEILING = 5,       /* an attachment reached the ceiling of the case */
  TAUTLINE_SINGULAR = 6,      /* touching cables came into one line: tensions are not determined */
  TAUTLINE_EVENT_LIMIT = 7,   /* as many events as the options allow */
  TAUTLINE_STEP_LIMIT = 8,    /* as many steps as the options allow */
  TAUTLINE_NO_PROGRESS = 9,   /* event follows event and time does not advance */
  TAUTLINE_OVERFLOW = 10      /* the numbers of the motion no longer fit a double */
};

/* The version of the library: "0.1.0", and as TAUTLINE_VERSION_NUMBER. */
TAUTLINE_API const char* tautline_version(void);
TAUTLINE_API int32_t tautline_version_number(void);

/* A sentence on a status, or the name that files use: "simultaneous", "impact", "reached_duration".
 * Null for a value that the library does not know, so that a loop from 0 finds all. */
TAUTLINE_API const char* tautline_status_text(int32_t status);
TAUTLINE_API const char* tautline_law_name(int32_t law);
TAUTLINE_API const char* tautline_event_kind_name(int32_t kind);
TAUTLINE_API const char* tautline_ending_name(int32_t ending);

/* ---- Cases ---- */

typedef struct tautline_case tautline_case;

/* A massless inextensible line from a point of the world to a point of the body. */
typedef struct tautline_cable {
  int32_t size;         /* sizeof(tautline_cable) */
  int32_t taut;         /* not 0: it starts taut, and the start is moved onto it as far as needed */
  double anchor[2];     /* [m], in the world */
  double attachment[2]; /* [m], in the body's frame, from its centre of mass */
  double length;        /* [m], > 0 */
  double restitution;   /* [-], Newton's coefficient, 0 to 1 */
  double capture_speed; /* [m/s], >= 0: a slower impact does not rebound */
  int32_t table_points; /* how many pairs of `table` are this cable's; 0: `restitution` holds */
  int32_t reserved;     /* 0 */
} tautline_cable;

enum tautline_has { TAUTLINE_HAS_ANGLE_LIMIT = 1, TAUTLINE_HAS_CEILING = 2 };

/* One rigid body in the plane, but for its cables. */
typedef struct tautline_planar_case {
  int32_t size;       /* sizeof(tautline_planar_case) */
  int32_t has;        /* the sum of the tautline_has that apply; 0: none */
  double mass;        /* [kg], > 0 */
  double inertia;     /* [kg m^2] about the centre of mass; 0 only for a point mass */
  double gravity[2];  /* [m/s^2] */
  double start[6];    /* x, y [m], angle [rad], vx, vy [m/s], spin [rad/s], anticlockwise */
  double duration;    /* [s], > 0 */
  double angle_limit; /* [rad], > 0: the motion ends where |angle| reaches it; see `has` */
  double ceiling;     /* [m]: the motion ends where an attachment rises to it; see `has` */
} tautline_planar_case;

/* A case from numbers. `table` has `table_points` pairs of speed [m/s] and restitution [-], in
 * rising speed; each cable takes the next of them, as many as its own `table_points`. `name` is
 * UTF-8 and may be null. Null is returned only if memory is missing. Ask tautline_problems for what
 * is wrong. */
TAUTLINE_API tautline_case* tautline_case_from_numbers(const tautline_planar_case* numbers,
                                                       const tautline_cable* cables,
                                                       size_t cable_count, const double* table,
                                                       size_t table_points, const char* name);

/* A case from the text of a case file: TOML, or a JSON object with the same keys if it begins with
 * {. `length` is in bytes, at most 1048576. `source_name` names the text in sentences; null:
 * "case". Null is returned only if memory is missing. Ask tautline_problems for what is wrong. */
TAUTLINE_API tautline_case* tautline_case_from_text(const char* text, size_t length,
                                                    const char* source_name);

/* `base` with other values of `count` quantities. A quantity is a coordinate of the start ("x",
 * "vx"), "mass", "inertia", "gravity_x", "gravity_y", or "restitution", "length", "capture_speed"
 * of all cables, or of one, as in "length_0". `wrong`, unless null, gets the index of a name that
 * is refused. `to` gets a case, which may have problems, or null. */
TAUTLINE_API int32_t tautline_case_vary(const tautline_case* base, const char* const* names,
                                        const double* values, size_t count, tautline_case** to,
                                        size_t* wrong);

TAUTLINE_API void tautline_case_free(tautline_case* the_case);

/* Everything that is wrong with a case, one sentence a line; a length of 0: tautline_solve accepts
 * it. Text is refused with the sentences that the program `tautline` has for the same file. */
TAUTLINE_API size_t tautline_problems(const tautline_case* the_case, char* text, size_t room);

/* How the start was changed for cables that start taut, one sentence a line; usually empty. */
TAUTLINE_API size_t tautline_notes(const tautline_case* the_case, char* text, size_t room);

/* The name of a case. */
TAUTLINE_API size_t tautline_case_name(const tautline_case* the_case, char* text, size_t room);

enum tautline_format { TAUTLINE_TOML = 0, TAUTLINE_JSON = 1 };

/* The case as the text of a case file that reads back as the same case, bit for bit.
 * `length` gets the length of the whole text. */
TAUTLINE_API int32_t tautline_case_text(const tautline_case* the_case, int32_t format, char* text,
                                        size_t room, size_t* length);

/* How many numbers a state has, and the name and unit of each: x, y [m], angle [rad], vx, vy [m/s]
 * and spin [rad/s] of a body in the plane. 0, and null, for a case with problems or a wrong index.
 */
TAUTLINE_API size_t tautline_coordinates(const tautline_case* the_case);
TAUTLINE_API const char* tautline_coordinate_name(const tautline_case* the_case, size_t index);
TAUTLINE_API const char* tautline_coordinate_unit(const tautline_case* the_case, size_t index);

/* How many cables a case has, the width of a row of tensions or impulses. 0 for one with problems.
 */
TAUTLINE_API size_t tautline_cables(const tautline_case* the_case);

/* The gap [m], length less distance, and its rate [m/s] of each cable, at `count` states of any
 * origin. `gaps` and `rates` are rows of tautline_cables numbers. */
TAUTLINE_API int32_t tautline_gaps(const tautline_case* the_case, const double* states,
                                   size_t count, double* gaps, double* rates);

/* ---- Solving ---- */

typedef struct tautline_motion tautline_motion;

/* How a case is solved. 0 is the default of each member: set `size` and what you want to change. */
typedef struct tautline_options {
  int32_t size; /* sizeof(tautline_options) */
  int32_t law;  /* a tautline_law */
  double
      completion_error; /* [-] to the velocities, by completing infinitely many bounces; 0: 1e-16 */
  double completion_speed;  /* [m/s], > 0: instead, bounces up to this are completed; 0: `error`
                               holds */
  double completion_margin; /* [-], how far a derivative may grow while they last; 0: 20 */
  int32_t max_events;       /* > 0: the motion ends there; 0: 200000, about a second of work */
  int32_t max_steps;        /* of taut motion and of springs, > 0; 0: 200000, about a second */
  int32_t until_locked;     /* not 0: the motion ends where nothing but one swing can follow */
  int32_t swing_ahead;      /* not 0, with `until_locked`: at the lock already, if it is certain */
} tautline_options;

/* What is wrong with `options`, one sentence a line. Null is right: the defaults. */
TAUTLINE_API size_t tautline_option_problems(const tautline_options* options, char* text,
                                             size_t room);

/* The exact motion of a case without problems. `options` may be null. `to` gets the motion, or
 * null. */
TAUTLINE_API int32_t tautline_solve(const tautline_case* the_case, const tautline_options* options,
                                    tautline_motion** to);

TAUTLINE_API void tautline_motion_free(tautline_motion* motion);

/* A motion in short. */
typedef struct tautline_summary {
  int32_t size;    /* sizeof(tautline_summary) */
  int32_t status;  /* TAUTLINE_OK; of a sweep also TAUTLINE_BAD_CASE, then the rest is 0 and NaN */
  int32_t ending;  /* a tautline_ending */
  int32_t taut;    /* the set of cables that are taut at the end */
  int32_t events;  /* how many rows tautline_events has */
  int32_t impacts; /* how many of them are impacts */
  int32_t arcs;    /* how many rows tautline_arcs has */
  int32_t accumulations; /* how many rows tautline_accumulations has */
  double end_time;       /* [s]: states are known from 0 to there */
  double start_energy;   /* [J], kinetic and potential; zero potential at the origin of the world */
  double end_energy;     /* [J] */
  double
      repeat_start; /* [s]: from there the arcs are one period that repeats to the end; NaN: none */
  double repeat_period; /* [s], or NaN */
  double repeat_turn;   /* [rad], by which the angle grows in each period, or NaN */
} tautline_summary;

/* `to->size` must be set. */
TAUTLINE_API int32_t tautline_summarise(const tautline_motion* motion, tautline_summary* to);

/* ---- States at times ---- */

/* Each takes `count` times [s] in any order, all in [0, end_time]. At an event they give what is
 * after it. If a time is refused the status is TAUTLINE_BAD_TIME and `wrong`, unless null, gets its
 * index; no array is written. */

/* Rows of tautline_coordinates numbers, and the set of taut cables at each time. */
TAUTLINE_API int32_t tautline_states(const tautline_motion* motion, const double* times,
                                     size_t count, double* states, int32_t* taut, size_t* wrong);

/* Rows of tautline_cables tensions [N], 0 of a slack cable. Of a redundant set of cables the
 * smallest. */
TAUTLINE_API int32_t tautline_tensions(const tautline_motion* motion, const double* times,
                                       size_t count, double* tensions, size_t* wrong);

/* Energies [J]; zero potential at the origin of the world. */
TAUTLINE_API int32_t tautline_energy(const tautline_motion* motion, const double* times,
                                     size_t count, double* kinetic, double* potential,
                                     double* total, size_t* wrong);

/* ---- Events ---- */

/* The columns of events `first` to `first + count - 1`, in order of time.
 * time [s]; kind, a tautline_event_kind; cables, the set that takes part; before and after, states
 * in rows of tautline_coordinates; impulses [N s] in rows of tautline_cables, 0 of a cable that
 * takes no part. At the completion of an accumulation an impulse may be < 0: gravity will have done
 * that part. */
TAUTLINE_API int32_t tautline_events(const tautline_motion* motion, size_t first, size_t count,
                                     double* time, int32_t* kind, int32_t* cables, double* before,
                                     double* after, double* impulses);

/* The columns of arcs, the stretches without events: start and end [s], and the set of taut cables.
 */
TAUTLINE_API int32_t tautline_arcs(const tautline_motion* motion, size_t first, size_t count,
                                   double* start, double* end, int32_t* taut);

/* The columns of accumulations, infinitely many impacts in a finite time: start [s], of the event
 * that completes them; limit [s] of the times of the impacts; by how much that may be wrong [s];
 * the set of cables that are taut from then on; the energy [J] that the impacts after `start` lose.
 */
TAUTLINE_API int32_t tautline_accumulations(const tautline_motion* motion, size_t first,
                                            size_t count, double* start, double* limit,
                                            double* uncertainty, int32_t* cables,
                                            double* energy_lost);

/* ---- Settling ---- */

/* How a motion settles. Numbers that do not apply are NaN. */
typedef struct tautline_settling {
  int32_t size;           /* sizeof(tautline_settling) */
  int32_t cables;         /* the final set of taut cables; 0: the motion ends without one */
  int32_t permanent;      /* 1: no tension falls to zero ever after; 0: not so, or unknown */
  int32_t rests;          /* 1: nothing is left to swing */
  int32_t swings;         /* 1: the numbers of the swing below apply */
  int32_t goes_round;     /* 1: the swing has no turning points, it goes round and round */
  int32_t angle_of_cable; /* 1: the angles are those of the first cable that pulls, from gravity's
                             direction; 0: of the body */
  int32_t reserved;       /* 0 */
  double time;            /* [s], from which on `cables` are taut */
  double uncertainty;     /* [s], of `time`; 0 where no accumulation led there */
  double last_impact_speed[2]; /* [m/s], of closing: 0.01 and 0.001 */
  double last_impact_time[2];  /* [s], of the last impact faster than that */
  double swing_energy;         /* [J], above the equilibrium that it swings about */
  double swing_period;         /* [s] */
  double swing_least;          /* [rad], the smaller of the angles at its turning points */
  double swing_largest;        /* [rad], the other */
  double swing_amplitude;      /* [rad], half the difference */
  double swing_tension;        /* [N], the largest of one cable; known with `swing_ahead` alone */
} tautline_settling;

/* `to->size` must be set. Looks past the end of the motion if its swing is not known by then. */
TAUTLINE_API int32_t tautline_settle(const tautline_motion* motion, tautline_settling* to);

/* ---- How far the numbers can be trusted ---- */

/* The bounds of errors compare with the exact motion of the doubles of the case. The first of these
 * calls computes them, in about the time of the solution, and the motion keeps them. */

/* `horizon` gets the first instant [s] at which nothing is sure any more, infinity if there is
 * none. `lock_error` gets a bound [s] of the last event's error if cables become taut for the rest
 * of the motion after that, NaN if it is not known. `unsure` gets how many rows tautline_unsure
 * has. */
TAUTLINE_API int32_t tautline_horizon(const tautline_motion* motion, double* horizon,
                                      double* lock_error, size_t* unsure);

/* The columns of stretches in which nothing is sure: from and until [s], infinity at the end. If
 * rounding decides between two motions at `from`, tie_kind is the tautline_event_kind that it
 * decides and tie_cables their set; otherwise -1 and 0: errors have grown. */
TAUTLINE_API int32_t tautline_unsure(const tautline_motion* motion, size_t first, size_t count,
                                     double* from, double* until, int32_t* tie_kind,
                                     int32_t* tie_cables);

/* The columns of bounds of the errors of events, each in the unit of what it bounds; NaN where
 * nothing is sure. rate: of the fastest closing rate [m/s]. indeterminate: the set of cables whose
 * impulse can be split in more than one way; the events have the split of smallest size. */
TAUTLINE_API int32_t tautline_event_errors(const tautline_motion* motion, size_t first,
                                           size_t count, double* time, double* rate, double* before,
                                           double* after, double* impulses, int32_t* indeterminate);

/* Bounds of the errors of states, in rows of tautline_coordinates, and of the energy [J], at
 * `count` times, which are checked as those of tautline_states. NaN where nothing is sure. */
TAUTLINE_API int32_t tautline_state_errors(const tautline_motion* motion, const double* times,
                                           size_t count, double* states, double* energy,
                                           size_t* wrong);

/* ---- Sweeps ---- */

/* Solves `count` cases of the same width of state in `threads` threads, 0: one for each processor,
 * at most 256. Several motions at a time share a thread's registers, so this is faster than solving
 * one after the other. The results are those of tautline_solve, bit for bit, in any number of
 * threads.
 *
 * times: `time_count` of them [s], >= 0, the same for all cases.
 * summaries: one for each case, settlings likewise; the first one's `size` must be set.
 * states: for each case `time_count` rows of tautline_coordinates; NaN at times after its end.
 *
 * A case with problems does not stop the others: its summary says TAUTLINE_BAD_CASE, its other
 * numbers are 0 and NaN. If an argument is refused, `wrong`, unless null, gets the index of the
 * case, time or name. With TAUTLINE_OUT_OF_MEMORY some rows may have been written. */
TAUTLINE_API int32_t tautline_sweep(const tautline_case* const* cases, size_t count,
                                    const tautline_options* options, int32_t threads,
                                    const double* times, size_t time_count,
                                    tautline_summary* summaries, tautline_settling* settlings,
                                    double* states, size_t* wrong);

/* The same of `count` variations of `base`, as tautline_case_vary makes them. `values` has a row of
 * `name_count` values for each. */
TAUTLINE_API int32_t tautline_sweep_varied(const tautline_case* base, const char* const* names,
                                           size_t name_count, const double* values, size_t count,
                                           const tautline_options* options, int32_t threads,
                                           const double* times, size_t time_count,
                                           tautline_summary* summaries,
                                           tautline_settling* settlings, double* states,
                                           size_t* wrong);

#ifdef __cplusplus
}
#endif

#endif
