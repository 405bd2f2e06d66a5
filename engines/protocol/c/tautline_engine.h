// An engine in a process of its own, in C99 and POSIX, with the library Jansson: `tautline_serve`
// answers tautline's messages until standard input ends. The protocol is the README above. To be
// included first: POSIX wants to be asked for.
#pragma once
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#include <stdio.h>
#include <unistd.h>

#include "tautline_answers.h"

static json_t* tautline_answer(const char* info, tautline_engine* engine, json_t* request) {
  json_t* const params = json_object_get(request, "params");
  const char* method = json_string_value(json_object_get(request, "method"));
  const double dt = json_number_value(json_object_get(params, "dt"));
  const tautline_model* const model = engine->model;
  method = method ? method : "";
  if (!strcmp(method, "info")) return tautline_info(info, engine);
  if (!strcmp(method, "start")) return tautline_start(engine, params);
  if (!engine->run) return tautline_error(-32601, "there is no such method, or no run");
  if (!strcmp(method, "step") && model->step)
    return tautline_steps(engine, dt, (int)json_integer_value(json_object_get(params, "count")));
  if (!strcmp(method, "fly") && model->fly) return tautline_fly(engine, dt);
  if (!strcmp(method, "place") && model->place) return tautline_place(engine, params);
  if (!strcmp(method, "solve") && model->solve) return tautline_solve(engine, params);
  return tautline_error(-32601, "this model has no such method");
}

// Answers every request. `info` is {name, version, precision} as JSON.
static int tautline_serve(const char* info, const tautline_model* models, int count) {
  FILE* const out = fdopen(dup(1), "w");
  tautline_engine engine = {.models = models, .count = count};
  dup2(2, 1);  // standard output is the protocol's, whatever a library prints
  for (json_t* request; (request = json_loadf(stdin, JSON_DISABLE_EOF_CHECK, NULL));
       json_decref(request)) {
    json_t* const answer = tautline_answer(info, &engine, request);
    json_object_set_new(answer, "jsonrpc", json_string("2.0"));
    json_object_set(answer, "id", json_object_get(request, "id"));
    json_dumpf(answer, out, JSON_COMPACT);
    fputc('\n', out);
    fflush(out);
    json_decref(answer);
  }
  if (engine.run) engine.model->end(engine.run);
  json_decref(engine.kept);
  return 0;
}
