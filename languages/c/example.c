/* Prints the events of a case file, or what is wrong with it.
 *   cc example.c $(pkg-config --cflags --libs tautline) && ./a.out CASE.toml */
#include <stdio.h>
#include <stdlib.h>
#include <tautline/tautline.h>

int main(int argc, char** argv) {
  static char text[1 << 20];
  FILE* file = argc == 2 ? fopen(argv[1], "rb") : NULL;
  if (file == NULL) {
    fprintf(stderr, "usage: example CASE.toml\n");
    return 2;
  }
  const size_t length = fread(text, 1, sizeof text, file);
  fclose(file);
  if (length == sizeof text) {
    fprintf(stderr, "%s is longer than 1048575 bytes\n", argv[1]);
    return 2;
  }

  tautline_case* the_case = tautline_case_from_text(text, length, argv[1]);
  tautline_motion* motion = NULL;
  tautline_summary summary = {sizeof summary};
  int32_t status = tautline_solve(the_case, NULL, &motion);
  if (status == TAUTLINE_OK) status = tautline_summarise(motion, &summary);

  const size_t rows = (size_t)summary.events;
  double* time = malloc((rows + 1) * sizeof *time);
  int32_t* kind = malloc((rows + 1) * sizeof *kind);
  if (status == TAUTLINE_OK && time != NULL && kind != NULL) {
    status = tautline_events(motion, 0, rows, time, kind, NULL, NULL, NULL, NULL);
    for (size_t i = 0; i < rows; ++i) printf("%-6s at %.9f s\n", tautline_event_kind_name(kind[i]), time[i]);
  } else if (status == TAUTLINE_BAD_CASE) {
    tautline_problems(the_case, text, sizeof text);
    fprintf(stderr, "%s\n", text);
  }
  if (time == NULL || kind == NULL) status = TAUTLINE_OUT_OF_MEMORY;
  free(time);
  free(kind);
  tautline_motion_free(motion);
  tautline_case_free(the_case);
  return status == TAUTLINE_OK ? 0 : 2;
}
