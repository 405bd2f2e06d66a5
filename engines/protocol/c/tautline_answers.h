// What an engine answers to a request: an object with its `result` or its `error`.
#pragma once
#include "tautline_cable.h"

// A model of a cable: its name, what the protocol says of it as JSON, and what a run of it does.
// One that is driven by steps has `step`, one that is driven by events `fly`, `place` and `solve`.
typedef struct {
  const char *name, *info;
  // NULL where the engine cannot do what the case asks for; `*why` is then "unsupported: ..."
  void* (*start)(const tautline_case*, double step, const char* law, const char** why);
  void (*state)(void* run, double state[6]);
  void (*step)(void* run, double dt, double* impulses);
  void (*fly)(void* run, double dt);
  void (*place)(void* run, const double state[6]);
  void (*solve)(void* run, int count, const int* cables, const double* rates, double* impulses);
  void (*end)(void* run);
} tautline_model;

// Which engine answers, and what it runs; `kept` holds what `the_case` points into.
typedef struct {
  const tautline_model *models, *model;
  int count;  // of models
  tautline_case the_case;
  json_t* kept;
  void* run;
} tautline_engine;

static json_t* tautline_error(int code, const char* message) {
  return json_pack("{s:{s:i, s:s}}", "error", "code", code, "message", message);
}
static json_t* tautline_state(const tautline_engine* engine) {
  double state[6];
  engine->model->state(engine->run, state);
  return tautline_add(json_array(), state, 6);
}

static json_t* tautline_info(const char* info, const tautline_engine* engine) {
  json_t *models = json_array(), *told = json_loads(info, 0, NULL);
  for (int k = 0; k < engine->count; ++k)
    json_array_append_new(models, json_loads(engine->models[k].info, 0, NULL));
  json_object_update_new(told, json_pack("{s:i, s:o}", "protocol", 1, "models", models));
  return json_pack("{s:o}", "result", told);
}

static json_t* tautline_start(tautline_engine* engine, json_t* params) {
  const char *name = "", *law = NULL, *why = "unsupported: there is no such model";
  double step = 0;
  json_t* from = NULL;
  json_unpack(params, "{s:o, s:s, s:F, s:s}", "case", &from, "model", &name, "step", &step, "law",
              &law);
  if (engine->run) engine->model->end(engine->run);
  json_decref(engine->kept);
  engine->kept = json_incref(params);
  engine->the_case = tautline_case_of(from);
  engine->run = NULL;
  for (int k = 0; k < engine->count && !engine->run; ++k)
    if (!strcmp((engine->model = &engine->models[k])->name, name))
      engine->run = engine->model->start(&engine->the_case, step, law, &why);
  return engine->run ? json_pack("{s:{s:o}}", "result", "state", tautline_state(engine))
                     : tautline_error(-32602, why);
}

static json_t* tautline_steps(tautline_engine* engine, double dt, int count) {
  json_t* steps = json_array();
  for (double impulses[tautline_most_cables]; count > 0; --count) {
    engine->model->step(engine->run, dt, impulses);
    json_array_append_new(steps,
                          tautline_add(tautline_state(engine), impulses, engine->the_case.cables));
  }
  return json_pack("{s:{s:o}}", "result", "steps", steps);
}

static json_t* tautline_fly(tautline_engine* engine, double dt) {
  engine->model->fly(engine->run, dt);
  return json_pack("{s:{s:o}}", "result", "state", tautline_state(engine));
}

static json_t* tautline_place(tautline_engine* engine, json_t* params) {
  double state[6];
  tautline_read(json_object_get(params, "state"), 6, state);
  engine->model->place(engine->run, state);
  return json_pack("{s:{s:o}}", "result", "state", tautline_state(engine));
}

static json_t* tautline_solve(tautline_engine* engine, json_t* params) {
  double rates[tautline_most_cables], impulses[tautline_most_cables];
  int cables[tautline_most_cables], count = 0;
  json_t *wanted = json_object_get(params, "cables"), *cable;
  for (; count < tautline_most_cables && (cable = json_array_get(wanted, count)); ++count)
    cables[count] = (int)json_integer_value(cable);
  tautline_read(json_object_get(params, "rates"), count, rates);
  engine->model->solve(engine->run, count, cables, rates, impulses);
  json_t* found = tautline_add(json_array(), impulses, count);
  return json_pack("{s:{s:o, s:o}}", "result", "impulses", found, "state", tautline_state(engine));
}
