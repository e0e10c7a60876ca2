// SPDX-License-Identifier: Apache-2.0
#include "bench/timed_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

#include "bench/machine.h"
#include "bench/measures.h"

namespace hexweave::bench {

namespace {

constexpr EllipticOptions reference_options{1e-9, 150};
/// What the last displacement and the residual of a reference must be below: a hundredth of the
/// smallest error measured against it.
constexpr double trusted_displacement = 0.01 * fine_error;

/// More cycles than this are not tried.
constexpr int most_cycles = 256;

/// An error this large, in cells, will not come back.
constexpr double hopeless_error = 1e6;

double seconds_now(Clock clock) {
    timespec now{};
    clock_gettime(clock == Clock::processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Stopwatch {
public:
    explicit Stopwatch(Clock clock = Clock::processor) : clock_(clock) {}
    void start() { begin_ = seconds_now(clock_); }
    void stop() { seconds_ += seconds_now(clock_) - begin_; }
    double seconds() const { return seconds_; }

private:
    Clock clock_;
    double begin_ = 0;
    double seconds_ = 0;
};

MethodRun method_run(const Problem& problem, std::string family, std::string name) {
    MethodRun run;
    run.problem = problem.name;
    run.extent = problem.points.extent();
    run.family = std::move(family);
    run.name = std::move(name);
    return run;
}

/// Errors after so many cycles, each computed once.
class ErrorByCycles {
public:
    ErrorByCycles(const Problem& problem, const PointField& reference)
        : problem_(problem), reference_(reference) {}

    double operator()(int cycles) {
        const auto known = errors_.find(cycles);
        if (known != errors_.end()) return known->second;
        Problem work = problem_;
        solve_elliptic(work.points, work.parameters, {0, cycles});
        const double error = error_in_cells(work.points, reference_);
        errors_[cycles] = error;
        return error;
    }

    /// The smallest number of cycles within `goal`, taking errors to fall with cycles.
    std::optional<int> cycles_to(double goal) {
        int above = 0;  // cycles known to be too few
        int enough = 4;
        while (!((*this)(enough) <= goal)) {
            above = enough;
            enough *= 2;
            if (enough > most_cycles) return std::nullopt;
        }
        while (enough - above > 1) {
            const int middle = (above + enough) / 2;
            ((*this)(middle) <= goal ? enough : above) = middle;
        }
        return enough;
    }

private:
    const Problem& problem_;
    const PointField& reference_;
    std::map<int, double> errors_;
};

std::optional<Timing> time_own_cycles(const Problem& problem, std::optional<int> cycles,
                                      int repeats) {
    if (!cycles) return std::nullopt;
    std::vector<double> seconds;
    seconds.reserve(static_cast<std::size_t>(repeats));
    for (int n = 0; n < repeats; ++n) seconds.push_back(time_cycles(problem, *cycles));
    return Timing{median(seconds), *cycles};
}

}  // namespace

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double time_cycles(const Problem& problem, int cycles, Clock clock) {
    Problem work = problem;
    Stopwatch watch(clock);
    watch.start();
    solve_elliptic(work.points, work.parameters, {0, cycles});
    watch.stop();
    return watch.seconds();
}

MethodRun time_yardstick(const Problem& problem, const PointField& reference,
                         const Yardstick& yardstick, double limit) {
    MethodRun run = method_run(problem, yardstick.family, yardstick.name);
    PointField points = problem.points;
    PeakMemory memory;
    Stopwatch watch;
    watch.start();
    yardstick.run(problem, [&](int cycles, const std::function<void(PointField&)>& copy) {
        watch.stop();
        copy(points);
        const double error = error_in_cells(points, reference);
        const Timing timing{watch.seconds(), cycles};
        if (error <= coarse_error && !run.to_coarse) run.to_coarse = timing;
        if (error <= fine_error) run.to_fine = timing;
        run.diverged = !(error < hopeless_error) && cycles > 1;
        watch.start();
        return !run.to_fine && !run.diverged && timing.seconds < limit;
    });
    watch.stop();
    run.seconds = watch.seconds();
    run.bytes_per_point = memory.bytes() / static_cast<double>(run.extent.nodes());
    return run;
}

MethodRun time_own_solver(const Problem& problem, const PointField& reference, int repeats) {
    MethodRun run = method_run(problem, "hexweave", "hexweave");
    {
        Problem work = problem;
        PeakMemory memory;
        solve_elliptic(work.points, work.parameters, {0, 2});
        run.bytes_per_point = memory.bytes() / static_cast<double>(run.extent.nodes());
    }
    ErrorByCycles error(problem, reference);
    run.to_fine = time_own_cycles(problem, error.cycles_to(fine_error), repeats);
    run.to_coarse = time_own_cycles(problem, error.cycles_to(coarse_error), repeats);
    if (run.to_fine) run.seconds = run.to_fine->seconds;
    return run;
}

std::optional<int> cycles_to(const Problem& problem, const PointField& reference, double goal) {
    return ErrorByCycles(problem, reference).cycles_to(goal);
}

bool Reference::trusted() const {
    return solve.displacement < trusted_displacement && residual < trusted_displacement;
}

Reference converged_grid(const Problem& problem) {
    Problem work = problem;
    Reference reference;
    reference.solve = solve_elliptic(work.points, work.parameters, reference_options);
    reference.residual = residual_in_cells(work.points, work.parameters);
    reference.points = std::move(work.points);
    return reference;
}

}  // namespace hexweave::bench
