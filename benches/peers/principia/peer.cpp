// Principia's solver of Euler's equations as a contestant: its `EulerSolver`, as it stands, on the free bodies of the report.
//
// The lines in which it speaks are those of `benches/speed/contest.rs`; `build.py` beside this file compiles it.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "geometry/frame.hpp"
#include "physics/euler_solver.hpp"
#include "problems.hpp"  // Written by build.py: the data of tests/data.
#include "quantities/si.hpp"

using namespace principia::geometry::_frame;
using namespace principia::geometry::_grassmann;
using namespace principia::geometry::_instant;
using namespace principia::geometry::_quaternion;
using namespace principia::geometry::_r3_element;
using namespace principia::geometry::_r3x3_matrix;
using namespace principia::geometry::_space;
using namespace principia::physics::_euler_solver;
using namespace principia::physics::_tensors;
using namespace principia::quantities::_named_quantities;
using namespace principia::quantities::_quantities;
using namespace principia::quantities::_si;

namespace {

using World = Frame<struct WorldTag, Inertial>;
// Principal axes in the order of their moments, the smallest first, as the solver wants them.
using Body = Frame<struct BodyTag>;
using Solver = EulerSolver<World, Body>;

struct Sample {
  AngularVelocity<Body> omega;
  Solver::AttitudeRotation attitude;
};

// The solver's axes are the problem's, or, where the first moment is not the smallest, these: its x is axis 2 and its y
// is axis 1 backwards.
bool Turned(Problem const& problem) {
  return problem.moments[0] > problem.moments[1];
}

void Solve(Problem const& problem, std::vector<Sample>& samples) {
  auto const* I = problem.moments;
  auto const* w = problem.start;
  auto const moment = si::Unit<MomentOfInertia>;
  auto const momentum = si::Unit<AngularMomentum>;
  // All attitudes begin with the identity, so that what the solver is asked for is the attitude since then.
  bool const turned = Turned(problem);
  auto const moments = turned ? R3Element<MomentOfInertia>(I[1] * moment, I[0] * moment, I[2] * moment)
                              : R3Element<MomentOfInertia>(I[0] * moment, I[1] * moment, I[2] * moment);
  auto const start = turned ? Bivector<AngularMomentum, World>(
                                  {I[1] * w[1] * momentum, -I[0] * w[0] * momentum, I[2] * w[2] * momentum})
                            : Bivector<AngularMomentum, World>(
                                  {I[0] * w[0] * momentum, I[1] * w[1] * momentum, I[2] * w[2] * momentum});
  Solver const solver(InertiaTensor<Body>(R3x3Matrix<MomentOfInertia>::DiagonalMatrix(moments)),
                      start,
                      Solver::AttitudeRotation::Identity(),
                      Instant());
  samples.clear();
  for (int i = 0; i <= problem.steps; ++i) {
    Instant const t = Instant() + problem.times[i] * Second;
    auto const momentum_now = solver.AngularMomentumAt(t);
    samples.push_back({solver.AngularVelocityFor(momentum_now), solver.AttitudeAt(momentum_now, t)});
  }
}

// The larger of |δω| and the angle between the attitudes, over all samples with a reference, as in `peers.py`.
double Error(Problem const& problem, std::vector<Sample> const& samples) {
  bool const turned = Turned(problem);
  double worst = 0;
  for (int row = 0; row < problem.kept; ++row) {
    Sample const& sample = samples[problem.index[row]];
    double const* high = problem.high + 7 * row;
    double const* low = problem.low + 7 * row;
    auto const found = sample.omega.coordinates();
    double const x = found.x / (Radian / Second), y = found.y / (Radian / Second), z = found.z / (Radian / Second);
    double const omega[3] = {turned ? -y : x, turned ? x : y, z};
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      double const off = (omega[k] - high[k]) - low[k];
      square += off * off;
    }
    auto const q = sample.attitude.quaternion();
    auto const v = q.imaginary_part();
    // The same rotation between the problem's axes.
    double e[4] = {q.real_part(), turned ? -v.y : v.x, turned ? v.x : v.y, v.z};
    double const *p = high + 3, *r = low + 3;
    double const sign = p[0] * e[0] + p[1] * e[1] + p[2] * e[2] + p[3] * e[3] < 0 ? -1 : 1;
    double d[4], along = 1;
    for (int k = 0; k < 4; ++k) {
      d[k] = (sign * e[k] - p[k]) - r[k];
      along += p[k] * d[k];
    }
    double const a = p[0] * d[1] - p[1] * d[0] - p[2] * d[3] + p[3] * d[2];
    double const b = p[0] * d[2] + p[1] * d[3] - p[2] * d[0] - p[3] * d[1];
    double const c = p[0] * d[3] - p[1] * d[2] + p[2] * d[1] - p[3] * d[0];
    double const angle = 2 * std::atan2(std::sqrt(a * a + b * b + c * c), along);
    for (double const error : {std::sqrt(square), angle}) {
      if (!(error <= worst)) {
        worst = error;
      }
    }
  }
  return worst;
}

}  // namespace

int main() {
  constexpr double slice = 0.004;
  std::string line;
  while (std::getline(std::cin, line)) {
    if (line == "list") {
      std::printf("version\tprincipia\t%s\nversion\tclang\t%s\n", PRINCIPIA_COMMIT, __clang_version__);
      for (auto const& problem : problems) {
        std::printf("entry\t%s\t%s\tclosed form\t\n", problem.name, CONTESTANT);
      }
      std::puts("end");
    } else if (std::size_t const number = line.rfind("run ", 0) == 0 ? std::stoul(line.substr(4)) : ~0ul;
               number < std::size(problems)) {
      auto const& problem = problems[number];
      std::vector<Sample> samples;
      auto const began = std::chrono::steady_clock::now();
      auto const since = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      };
      int runs = 0;
      do {
        Solve(problem, samples);
        asm volatile("" : : "r"(samples.data()) : "memory");
        ++runs;
      } while (since() < slice);
      double const seconds = since() / runs;
      std::printf("%.17e\t-\t%.17e\n", Error(problem, samples), seconds);
    } else {
      std::printf("failed\tno such line: %s\n", line.c_str());
    }
    std::fflush(stdout);
  }
}
