/* Checks an engine's samples against a test vector:  check_vector VECTOR.txt SAMPLES STEP
   SAMPLES has a line `time x y angle` for the start and each step, `-` is standard input; what follows on a line and
   lines that begin with # are ignored. Exit code 0: right, 1: wrong, 2: cannot be used.  cc check_vector.c -lm */
#include <math.h>
#include <stdio.h>
#include <string.h>
static int unusable(const char* why) { return fprintf(stderr, "%s\n", why), 2; }
int main(int count, char** words) {
  FILE* vector = count == 4 ? fopen(words[1], "r") : NULL;
  FILE* samples = count != 4 ? NULL : strcmp(words[2], "-") == 0 ? stdin : fopen(words[2], "r");
  double step = 0, radius = 0, fastest = 0, growth, longest, worst = 0, hit = 0;
  double a[4] = {-1}, b[4] = {-1}, row[4]; /* the samples before and after a row: time, x, y, angle */
  char line[4096], kind[16];
  int asked = 0;
  if (!vector || !samples || sscanf(words[3], "%lf", &step) != 1 || !(step > 0)) return unusable("needs VECTOR.txt SAMPLES STEP");
  if (!fgets(line, sizeof line, vector) || strcmp(line, "tautline-vector-1\n")) return unusable("not a tautline-vector-1");
  while (fgets(line, sizeof line, vector)) {
    if (sscanf(line, "radius %lf", &radius) == 1 || sscanf(line, "fastest %lf", &fastest) == 1) continue;
    if (sscanf(line, "%15s%lf%lf%lf%lf%*f%*f%*f%lf%lf", kind, row, row + 1, row + 2, row + 3, &growth, &longest) != 7 ||
        step > longest * (1 + 1e-9)) continue; /* no row, or none that can judge such a step */
    while (a[0] < 0 || b[0] < row[0] - 1e-9 * step) {
      if (!fgets(line, sizeof line, samples)) return printf("wrong: no sample at t = %g or later\n", row[0]), 1;
      if (line[0] == '#' || !line[strspn(line, " \t\r\n")]) continue;
      memcpy(a, b, sizeof a);
      if (sscanf(line, "%lf%lf%lf%lf", b, b + 1, b + 2, b + 3) != 4) return unusable("a sample is not `time x y angle`");
    }
    const double part = b[0] > a[0] ? fmin(1, (row[0] - a[0]) / (b[0] - a[0])) : 1, allowed = 2 * step * fastest * growth;
    double by[4];
    for (int i = 1; i < 4; i++) by[i] = a[i] + part * (b[i] - a[i]) - row[i];
    const double off = hypot(hypot(by[1], by[2]), radius * by[3]);
    if (!(off <= allowed)) return printf("wrong: at t = %g it is %.2g m off, %.2g m are allowed; the impact before is at t = %g\n",
                                         row[0], off, allowed, hit), 1;
    worst = fmax(worst, off / allowed), asked++, hit = strcmp(kind, "impact") == 0 ? row[0] : hit;
  }
  if (asked < 2) return unusable("this step is too long for the vector");
  return printf("right: %d rows asked, at worst %.2g of what is allowed\n", asked, worst), 0;
}
