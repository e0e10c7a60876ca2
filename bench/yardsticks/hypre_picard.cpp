// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/hypre_picard.h"

#include <HYPRE.h>
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_struct_ls.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bench/yardsticks/picard.h"

namespace hexweave::bench {

namespace {

using Step = std::array<int, 3>;

/// The offsets of a stencil: centre, then the neighbours, 9 or 19 in all.
std::vector<Step> stencil_steps(int axes) {
    std::vector<Step> steps{{0, 0, 0}};
    for (int c = axes == 3 ? -1 : 0; c <= (axes == 3 ? 1 : 0); ++c) {
        for (int b = -1; b <= 1; ++b) {
            for (int a = -1; a <= 1; ++a) {
                const int moved = std::abs(a) + std::abs(b) + std::abs(c);
                if (moved == 1 || moved == 2) steps.push_back({a, b, c});
            }
        }
    }
    return steps;
}

/// Minus the coefficient with which the stencil takes the neighbour at `step`.
double entry(const Stencil& c, const Step& step) {
    std::array<std::size_t, 3> moved{};
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (step[axis] != 0) moved[count++] = axis;
    }
    if (count == 0) return 1;
    if (count == 1) return -(c.second[moved[0]] + step[moved[0]] * c.first[moved[0]]);
    return -step[moved[0]] * step[moved[1]] * c.mixed[moved[0] + moved[1] - 1];
}

/// Whether the neighbour is an unknown: couplings to boundary nodes multiply zero, and hypre wants
/// them gone.
bool is_interior(const NodeLattice& lattice, std::size_t node, const Step& step) {
    const Extent& e = lattice.extent;
    const auto index = static_cast<std::ptrdiff_t>(node);
    const std::array<std::ptrdiff_t, 3> at{index % e.ni, index / lattice.strides[1] % e.nj,
                                           index / lattice.strides[2]};
    for (int axis = 0; axis < lattice.axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (at[a] + step[a] < 1 || at[a] + step[a] > e[axis] - 2) return false;
    }
    return true;
}

double component(const Vec3& v, int c) {
    return c == 0 ? v.x : c == 1 ? v.y : v.z;
}

void set_component(Vec3& v, int c, double value) {
    (c == 0 ? v.x : c == 1 ? v.y : v.z) = value;
}

/// Components that the problem does not have (z in a plane) are not solved for.
bool is_zero(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return v == 0; });
}

enum class StructuredSolver { smg, pfmg };

HYPRE_StructSolver make_preconditioner(StructuredSolver kind) {
    HYPRE_StructSolver solver = nullptr;
    if (kind == StructuredSolver::smg) {
        HYPRE_StructSMGCreate(MPI_COMM_WORLD, &solver);
        HYPRE_StructSMGSetMemoryUse(solver, 0);
        HYPRE_StructSMGSetMaxIter(solver, 1);
        HYPRE_StructSMGSetTol(solver, 0);
        HYPRE_StructSMGSetZeroGuess(solver);
        HYPRE_StructSMGSetNumPreRelax(solver, 1);
        HYPRE_StructSMGSetNumPostRelax(solver, 1);
    } else {
        HYPRE_StructPFMGCreate(MPI_COMM_WORLD, &solver);
        HYPRE_StructPFMGSetMaxIter(solver, 1);
        HYPRE_StructPFMGSetTol(solver, 0);
        HYPRE_StructPFMGSetZeroGuess(solver);
        HYPRE_StructPFMGSetRelaxType(solver, 1);
    }
    return solver;
}

/// The interior nodes as a hypre grid, and one linear system on it at a time.
class StructuredSystem {
public:
    StructuredSystem(const NodeLattice& lattice, StructuredSolver kind);
    ~StructuredSystem();
    StructuredSystem(const StructuredSystem&) = delete;
    StructuredSystem& operator=(const StructuredSystem&) = delete;

    void solve(const Stencils& stencils, const Nodes& residual, Nodes& step);

private:
    void set_matrix(const Stencils& stencils);
    void solve_component(HYPRE_StructSolver krylov, int c, const Nodes& residual, Nodes& step);

    NodeLattice lattice_;
    StructuredSolver kind_;
    std::vector<Step> steps_;
    std::array<HYPRE_Int, 3> low_{};
    std::array<HYPRE_Int, 3> high_{};
    HYPRE_StructGrid grid_ = nullptr;
    HYPRE_StructStencil stencil_ = nullptr;
    HYPRE_StructVector right_ = nullptr;
    HYPRE_StructVector left_ = nullptr;
    HYPRE_StructMatrix matrix_ = nullptr;
    std::vector<double> values_;
};

StructuredSystem::StructuredSystem(const NodeLattice& lattice, StructuredSolver kind)
    : lattice_(lattice), kind_(kind), steps_(stencil_steps(lattice.axes)) {
    const HYPRE_Int axes = lattice.axes;
    for (int axis = 0; axis < axes; ++axis) {
        low_[static_cast<std::size_t>(axis)] = 1;
        high_[static_cast<std::size_t>(axis)] = lattice.extent[axis] - 2;
    }
    HYPRE_StructGridCreate(MPI_COMM_WORLD, axes, &grid_);
    HYPRE_StructGridSetExtents(grid_, low_.data(), high_.data());
    HYPRE_StructGridAssemble(grid_);
    HYPRE_StructStencilCreate(axes, static_cast<HYPRE_Int>(steps_.size()), &stencil_);
    for (std::size_t e = 0; e < steps_.size(); ++e) {
        Step step = steps_[e];
        HYPRE_StructStencilSetElement(stencil_, static_cast<HYPRE_Int>(e), step.data());
    }
    for (HYPRE_StructVector* vector : {&right_, &left_}) {
        HYPRE_StructVectorCreate(MPI_COMM_WORLD, grid_, vector);
        HYPRE_StructVectorInitialize(*vector);
        HYPRE_StructVectorAssemble(*vector);
    }
}

StructuredSystem::~StructuredSystem() {
    if (matrix_ != nullptr) HYPRE_StructMatrixDestroy(matrix_);
    HYPRE_StructVectorDestroy(right_);
    HYPRE_StructVectorDestroy(left_);
    HYPRE_StructStencilDestroy(stencil_);
    HYPRE_StructGridDestroy(grid_);
}

void StructuredSystem::set_matrix(const Stencils& stencils) {
    if (matrix_ != nullptr) HYPRE_StructMatrixDestroy(matrix_);
    HYPRE_StructMatrixCreate(MPI_COMM_WORLD, grid_, stencil_, &matrix_);
    HYPRE_StructMatrixInitialize(matrix_);
    std::vector<double> values;
    values.reserve(lattice_.extent.nodes() * steps_.size());
    for_interior(lattice_, [&](std::size_t p) {
        for (const Step& step : steps_) {
            values.push_back(is_interior(lattice_, p, step) ? entry(stencils[p], step) : 0);
        }
    });
    std::vector<HYPRE_Int> entries;
    for (std::size_t n = 0; n < steps_.size(); ++n) entries.push_back(static_cast<HYPRE_Int>(n));
    HYPRE_StructMatrixSetBoxValues(matrix_, low_.data(), high_.data(),
                                   static_cast<HYPRE_Int>(entries.size()), entries.data(),
                                   values.data());
    HYPRE_StructMatrixAssemble(matrix_);
}

void StructuredSystem::solve_component(HYPRE_StructSolver krylov, int c, const Nodes& residual,
                                       Nodes& step) {
    values_.clear();
    for_interior(lattice_, [&](std::size_t p) { values_.push_back(component(residual[p], c)); });
    if (!is_zero(values_)) {
        HYPRE_StructVectorSetBoxValues(right_, low_.data(), high_.data(), values_.data());
        HYPRE_StructVectorSetConstantValues(left_, 0);
        HYPRE_StructBiCGSTABSolve(krylov, matrix_, right_, left_);
        HYPRE_ClearAllErrors();
        HYPRE_StructVectorGetBoxValues(left_, low_.data(), high_.data(), values_.data());
    }
    std::size_t at = 0;
    for_interior(lattice_, [&](std::size_t p) { set_component(step[p], c, values_[at++]); });
}

void StructuredSystem::solve(const Stencils& stencils, const Nodes& residual, Nodes& step) {
    set_matrix(stencils);
    HYPRE_StructSolver krylov = nullptr;
    HYPRE_StructBiCGSTABCreate(MPI_COMM_WORLD, &krylov);
    HYPRE_StructBiCGSTABSetTol(krylov, linear_reduction);
    HYPRE_StructBiCGSTABSetMaxIter(krylov, linear_iterations);
    HYPRE_StructSolver preconditioner = make_preconditioner(kind_);
    if (kind_ == StructuredSolver::smg) {
        HYPRE_StructBiCGSTABSetPrecond(krylov, HYPRE_StructSMGSolve, HYPRE_StructSMGSetup,
                                       preconditioner);
    } else {
        HYPRE_StructBiCGSTABSetPrecond(krylov, HYPRE_StructPFMGSolve, HYPRE_StructPFMGSetup,
                                       preconditioner);
    }
    HYPRE_StructBiCGSTABSetup(krylov, matrix_, right_, left_);
    for (int c = 0; c < 3; ++c) solve_component(krylov, c, residual, step);
    HYPRE_StructBiCGSTABDestroy(krylov);
    if (kind_ == StructuredSolver::smg) {
        HYPRE_StructSMGDestroy(preconditioner);
    } else {
        HYPRE_StructPFMGDestroy(preconditioner);
    }
}

/// The same system as a sparse matrix, for algebraic multigrid.
class SparseSystem {
public:
    explicit SparseSystem(const NodeLattice& lattice);
    ~SparseSystem();
    SparseSystem(const SparseSystem&) = delete;
    SparseSystem& operator=(const SparseSystem&) = delete;

    void solve(const Stencils& stencils, const Nodes& residual, Nodes& step);

private:
    HYPRE_IJMatrix make_matrix(const Stencils& stencils) const;
    void solve_component(HYPRE_Solver krylov, HYPRE_ParCSRMatrix matrix, int c,
                         const Nodes& residual, Nodes& step);

    NodeLattice lattice_;
    std::vector<Step> steps_;
    std::vector<HYPRE_Int> row_of_;  ///< -1 at boundary nodes
    std::vector<HYPRE_Int> rows_;    ///< 0, 1, 2, ...
    HYPRE_IJVector right_ = nullptr;
    HYPRE_IJVector left_ = nullptr;
    HYPRE_ParVector par_right_ = nullptr;
    HYPRE_ParVector par_left_ = nullptr;
    std::vector<double> values_;
};

SparseSystem::SparseSystem(const NodeLattice& lattice)
    : lattice_(lattice), steps_(stencil_steps(lattice.axes)), row_of_(lattice.extent.nodes(), -1) {
    HYPRE_Int rows = 0;
    for_interior(lattice, [&](std::size_t p) {
        rows_.push_back(rows);
        row_of_[p] = rows++;
    });
    void* object = nullptr;
    for (HYPRE_IJVector* vector : {&right_, &left_}) {
        HYPRE_IJVectorCreate(MPI_COMM_WORLD, 0, rows - 1, vector);
        HYPRE_IJVectorSetObjectType(*vector, HYPRE_PARCSR);
        HYPRE_IJVectorInitialize(*vector);
        HYPRE_IJVectorAssemble(*vector);
    }
    HYPRE_IJVectorGetObject(right_, &object);
    par_right_ = static_cast<HYPRE_ParVector>(object);
    HYPRE_IJVectorGetObject(left_, &object);
    par_left_ = static_cast<HYPRE_ParVector>(object);
}

SparseSystem::~SparseSystem() {
    HYPRE_IJVectorDestroy(right_);
    HYPRE_IJVectorDestroy(left_);
}

HYPRE_IJMatrix SparseSystem::make_matrix(const Stencils& stencils) const {
    const auto last = static_cast<HYPRE_Int>(rows_.size()) - 1;
    std::vector<HYPRE_Int> counts;
    std::vector<HYPRE_Int> columns;
    std::vector<double> values;
    for_interior(lattice_, [&](std::size_t p) {
        HYPRE_Int count = 0;
        for (const Step& s : steps_) {
            const std::ptrdiff_t offset = s[0] * lattice_.strides[0] + s[1] * lattice_.strides[1] +
                                          s[2] * lattice_.strides[2];
            const HYPRE_Int column =
                row_of_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(p) + offset)];
            if (column < 0) continue;
            columns.push_back(column);
            values.push_back(entry(stencils[p], s));
            ++count;
        }
        counts.push_back(count);
    });
    HYPRE_IJMatrix matrix = nullptr;
    HYPRE_IJMatrixCreate(MPI_COMM_WORLD, 0, last, 0, last, &matrix);
    HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(matrix, counts.data());
    HYPRE_IJMatrixInitialize(matrix);
    HYPRE_IJMatrixSetValues(matrix, last + 1, counts.data(), rows_.data(), columns.data(),
                            values.data());
    HYPRE_IJMatrixAssemble(matrix);
    return matrix;
}

void SparseSystem::solve_component(HYPRE_Solver krylov, HYPRE_ParCSRMatrix matrix, int c,
                                   const Nodes& residual, Nodes& step) {
    values_.clear();
    for_interior(lattice_, [&](std::size_t p) { values_.push_back(component(residual[p], c)); });
    if (!is_zero(values_)) {
        const auto count = static_cast<HYPRE_Int>(rows_.size());
        HYPRE_IJVectorSetValues(right_, count, rows_.data(), values_.data());
        HYPRE_ParVectorSetConstantValues(par_left_, 0);
        HYPRE_ParCSRBiCGSTABSolve(krylov, matrix, par_right_, par_left_);
        HYPRE_ClearAllErrors();
        HYPRE_IJVectorGetValues(left_, count, rows_.data(), values_.data());
    }
    std::size_t at = 0;
    for_interior(lattice_, [&](std::size_t p) { set_component(step[p], c, values_[at++]); });
}

void SparseSystem::solve(const Stencils& stencils, const Nodes& residual, Nodes& step) {
    HYPRE_IJMatrix ij = make_matrix(stencils);
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(ij, &object);
    auto* matrix = static_cast<HYPRE_ParCSRMatrix>(object);
    HYPRE_Solver preconditioner = nullptr;
    HYPRE_BoomerAMGCreate(&preconditioner);
    HYPRE_BoomerAMGSetMaxIter(preconditioner, 1);
    HYPRE_BoomerAMGSetTol(preconditioner, 0);
    HYPRE_BoomerAMGSetCoarsenType(preconditioner, 10);
    HYPRE_BoomerAMGSetInterpType(preconditioner, 6);
    HYPRE_BoomerAMGSetPMaxElmts(preconditioner, 4);
    HYPRE_BoomerAMGSetStrongThreshold(preconditioner, lattice_.axes == 3 ? 0.5 : 0.25);
    HYPRE_BoomerAMGSetPrintLevel(preconditioner, 0);
    HYPRE_Solver krylov = nullptr;
    HYPRE_ParCSRBiCGSTABCreate(MPI_COMM_WORLD, &krylov);
    HYPRE_ParCSRBiCGSTABSetTol(krylov, linear_reduction);
    HYPRE_ParCSRBiCGSTABSetMaxIter(krylov, linear_iterations);
    HYPRE_ParCSRBiCGSTABSetPrecond(krylov, HYPRE_BoomerAMGSolve, HYPRE_BoomerAMGSetup,
                                   preconditioner);
    HYPRE_ParCSRBiCGSTABSetup(krylov, matrix, par_right_, par_left_);
    for (int c = 0; c < 3; ++c) solve_component(krylov, matrix, c, residual, step);
    HYPRE_ParCSRBiCGSTABDestroy(krylov);
    HYPRE_BoomerAMGDestroy(preconditioner);
    HYPRE_IJMatrixDestroy(ij);
}

template <class System, class... Arguments>
Yardstick hypre_yardstick(const std::string& name, Arguments... arguments) {
    const auto run = [=](const Problem& problem, const Look& look) {
        System system(NodeLattice(problem.points.extent()), arguments...);
        const auto solve = [&](const Stencils& stencils, const Nodes& residual, Nodes& step) {
            system.solve(stencils, residual, step);
        };
        picard(problem, solve, look);
    };
    return {"hypre", "Picard + hypre " + name, run};
}

}  // namespace

HypreSession::HypreSession() {
    MPI_Init(nullptr, nullptr);
    HYPRE_Init();
}

HypreSession::~HypreSession() {
    HYPRE_Finalize();
    MPI_Finalize();
}

std::vector<Yardstick> hypre_yardsticks() {
    return {hypre_yardstick<StructuredSystem>("SMG", StructuredSolver::smg),
            hypre_yardstick<StructuredSystem>("PFMG", StructuredSolver::pfmg),
            hypre_yardstick<SparseSystem>("BoomerAMG")};
}

}  // namespace hexweave::bench
