// Checks an engine's samples against a test vector:  check_vector VECTOR.txt SAMPLES STEP
// SAMPLES has a line `time x y angle` for the start and each step; what follows on a line and lines that begin with #
// are ignored. Exit code 0: right, 1: wrong, 2: cannot be used.
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
using Pose = std::array<double, 4>;  // time, x, y, angle
int main(int count, char** words) {
  std::ifstream vector(count == 4 ? words[1] : ""), samples(count == 4 ? words[2] : "");
  const auto unusable = [](const std::string& why) { return std::fprintf(stderr, "%s\n", why.c_str()), 2; };
  double step = 0, radius = 0, fastest = 0, growth = 0, longest = 0, worst = 0, hit = 0, asked = 0;
  std::string line, next;
  if (!samples || !std::getline(vector, line) || std::sscanf(words[3], "%lf", &step) != 1 || !(step > 0))
    return unusable("needs VECTOR.txt SAMPLES STEP");
  if (line != "tautline-vector-1") return unusable("not a tautline-vector-1: " + line);
  Pose a{-1}, b{-1}, row;  // the samples before and after a row
  for (char kind[16]; std::getline(vector, line);) {
    std::sscanf(line.c_str(), "radius %lf", &radius), std::sscanf(line.c_str(), "fastest %lf", &fastest);
    const int found = std::sscanf(line.c_str(), "%15s%lf%lf%lf%lf%*f%*f%*f%lf%lf", kind, &row[0], &row[1], &row[2],
                                  &row[3], &growth, &longest);
    if (found != 7 || step > longest * (1 + 1e-9)) continue;  // no row, or none that can judge such a step
    while (a[0] < 0 || b[0] < row[0] - 1e-9 * step) {
      if (!std::getline(samples, next)) return std::printf("wrong: no sample at t = %g or later\n", row[0]), 1;
      if (next[0] == '#' || next.find_first_not_of(" \t\r") == next.npos) continue;
      a = b;
      const int numbers = std::sscanf(next.c_str(), "%lf%lf%lf%lf", &b[0], &b[1], &b[2], &b[3]);
      if (numbers != 4) return unusable("not `time x y angle`: " + next);
    }
    const double part = b[0] > a[0] ? std::fmin(1, (row[0] - a[0]) / (b[0] - a[0])) : 1;
    const auto by = [&](int i) { return a[i] + part * (b[i] - a[i]) - row[i]; };
    const double off = std::hypot(by(1), by(2), radius * by(3)), allowed = 2 * step * fastest * growth;
    const char* wrong = "wrong: at t = %g it is %.2g m off, %.2g m are allowed; the impact before is at t = %g\n";
    if (!(off <= allowed)) return std::printf(wrong, row[0], off, allowed, hit), 1;
    worst = std::fmax(worst, off / allowed), ++asked, hit = kind == std::string("impact") ? row[0] : hit;
  }
  if (asked < 2) return unusable("this step is too long for the vector");
  return std::printf("right: %g rows asked, at worst %.2g of what is allowed\n", asked, worst), 0;
}
