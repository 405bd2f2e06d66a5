// An engine in a process of its own, in C99 and POSIX, with the library Jansson: `tautline_serve`
// answers tautline's messages until standard input ends. The protocol is the README above.
#pragma once
#include <stdio.h>
#include <unistd.h>

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
  const char* info;  // {name, version, precision} as JSON
  const tautline_model *models, *model;
  int count;  // of models
  tautline_case the_case;
  json_t* kept;
  void* run;
  const char* problem;  // why the last request has no result
  int code;
} tautline_engine;

static json_t* tautline_add(json_t* array, const double* from, int count) {
  for (int k = 0; k < count; ++k) {
    const char* text = isnan(from[k]) ? "NaN" : from[k] > 0 ? "Infinity" : "-Infinity";
    json_array_append_new(array, isfinite(from[k]) ? json_real(from[k]) : json_string(text));
  }
  return array;
}

static json_t* tautline_state(const tautline_engine* engine, json_t* array) {
  double state[6];
  engine->model->state(engine->run, state);
  return tautline_add(array, state, 6);
}

static json_t* tautline_info(const tautline_engine* engine) {
  json_t *result = json_loads(engine->info, 0, NULL), *models = json_array();
  for (int k = 0; k < engine->count; ++k)
    json_array_append_new(models, json_loads(engine->models[k].info, 0, NULL));
  json_object_set_new(result, "protocol", json_integer(1));
  json_object_set_new(result, "models", models);
  return result;
}

static json_t* tautline_start(tautline_engine* engine, json_t* params) {
  const char* name = json_string_value(json_object_get(params, "model"));
  if (engine->run) engine->model->end(engine->run);
  json_decref(engine->kept);
  engine->kept = json_incref(params);
  engine->the_case = tautline_case_of(json_object_get(params, "case"));
  engine->run = NULL;
  engine->problem = "unsupported: there is no such model";
  engine->code = -32602;
  for (int k = 0; name && k < engine->count && !engine->run; ++k) {
    if (strcmp(engine->models[k].name, name)) continue;
    engine->model = &engine->models[k];
    engine->run =
        engine->model->start(&engine->the_case, json_number_value(json_object_get(params, "step")),
                             json_string_value(json_object_get(params, "law")), &engine->problem);
  }
  return engine->run ? json_pack("{s:o}", "state", tautline_state(engine, json_array())) : NULL;
}

static json_t* tautline_steps(tautline_engine* engine, double dt, int count) {
  json_t* steps = json_array();
  for (double impulses[tautline_most_cables]; count > 0; --count) {
    engine->model->step(engine->run, dt, impulses);
    json_array_append_new(steps, tautline_add(tautline_state(engine, json_array()), impulses,
                                              engine->the_case.cables));
  }
  return json_pack("{s:o}", "steps", steps);
}

static json_t* tautline_result(tautline_engine* engine, const char* method, json_t* params) {
  const double dt = json_number_value(json_object_get(params, "dt"));
  double numbers[6 + tautline_most_cables], impulses[tautline_most_cables];
  json_t* result = NULL;
  if (!strcmp(method, "info")) return tautline_info(engine);
  if (!strcmp(method, "start")) return tautline_start(engine, params);
  engine->problem = "there is no such method of this model, or no run";
  engine->code = -32601;
  if (!engine->run) return NULL;
  if (!strcmp(method, "step") && engine->model->step)
    return tautline_steps(engine, dt, (int)json_integer_value(json_object_get(params, "count")));
  if (!strcmp(method, "fly") && engine->model->fly) {
    engine->model->fly(engine->run, dt);
  } else if (!strcmp(method, "place") && engine->model->place) {
    tautline_read(json_object_get(params, "state"), 6, numbers);
    engine->model->place(engine->run, numbers);
  } else if (!strcmp(method, "solve") && engine->model->solve) {
    int cables[tautline_most_cables], count = 0;
    const json_t *wanted = json_object_get(params, "cables"), *cable;
    for (; count < tautline_most_cables && (cable = json_array_get(wanted, count)); ++count)
      cables[count] = (int)json_integer_value(cable);
    tautline_read(json_object_get(params, "rates"), count, numbers);
    engine->model->solve(engine->run, count, cables, numbers, impulses);
    result = json_pack("{s:o}", "impulses", tautline_add(json_array(), impulses, count));
  } else {
    return NULL;
  }
  result = result ? result : json_object();
  json_object_set_new(result, "state", tautline_state(engine, json_array()));
  return result;
}

// Answers every request. `info` is {name, version, precision} as JSON.
static int tautline_serve(const char* info, const tautline_model* models, int count) {
  FILE* const out = fdopen(dup(1), "w");
  tautline_engine engine = {.info = info, .models = models, .count = count};
  dup2(2, 1);  // standard output is the protocol's, whatever a library prints
  for (json_t* request; (request = json_loadf(stdin, JSON_DISABLE_EOF_CHECK, NULL));
       json_decref(request)) {
    const char* method = json_string_value(json_object_get(request, "method"));
    json_t* const result =
        tautline_result(&engine, method ? method : "", json_object_get(request, "params"));
    json_t* answer =
        json_pack("{s:s, s:O}", "jsonrpc", "2.0", "id", json_object_get(request, "id"));
    json_object_set_new(
        answer, result ? "result" : "error",
        result ? result : json_pack("{s:i, s:s}", "code", engine.code, "message", engine.problem));
    json_dumpf(answer, out, JSON_COMPACT);
    fputc('\n', out);
    fflush(out);
    json_decref(answer);
  }
  if (engine.run) engine.model->end(engine.run);
  json_decref(engine.kept);
  return 0;
}
