#include "core/linear_algebra/multifrontal_factor.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/linear_algebra/dense_kernels.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr double shared_work = 4e6;  // multiplications of one step that are worth a second core
constexpr int strip = 192;           // columns or rows that are worked on at a time then

}  // namespace

/// One factorisation under way.
template <class Number>
class MultifrontalFactor<Number>::Elimination {
  public:
    Elimination(MultifrontalFactor& target, const BlockGraph& graph, const BlockMatrix& matrix, double shift)
        : to_(target),
          fronts_(target.fronts_),
          block_(target.block_),
          graph_(graph),
          matrix_(matrix),
          shift_(shift),
          updates_(fronts_.count(), nullptr) {}

    bool run() {
        const EliminationSchedule& schedule = to_.schedule_;
        const int subtrees = static_cast<int>(schedule.subtrees.size());
        std::vector<Stacks> stacks(subtrees + 1);
        forEachChunk(subtrees, [&](int r) { runThrough(schedule.subtrees[r], stacks[r], false); });
        runThrough(schedule.top, stacks.back(), true);
        return !failed_;
    }

  private:
    /// Updates of fronts, by the parity of their depth.
    struct Stacks {
        std::array<BigBuffer<Number>, 2> memory;
        std::array<std::size_t, 2> used{0, 0};
    };

    void runThrough(const EliminationSchedule::Run& run, Stacks& stacks, bool on_all_cores) {
        std::vector<int> local_row(graph_.size());
        for (int s = 0; s < 2; ++s) stacks.memory[s] = BigBuffer<Number>(run.stack_sizes[s]);
        for (const int front : run.fronts) {
            if (failed_) return;
            eliminate(front, stacks, local_row, on_all_cores);
        }
    }

    void eliminate(int front, Stacks& stacks, std::vector<int>& local_row, bool on_all_cores) {
        const int columns = to_.columnCount(front), rows = to_.rowCount(front), stride = columns + rows;
        Number* panel = to_.values_.data() + to_.panel_starts_[front];
        takeEntries(front, panel, local_row);

        const int own = to_.schedule_.depth[front] % 2;
        Number* update = stacks.memory[own].data() + stacks.used[own];
        updates_[front] = update;
        stacks.used[own] += static_cast<std::size_t>(rows) * rows;
        const std::vector<int>& children = fronts_.children[front];
        for (const int child : children) addUpdate(child, front, 0, columns, panel, stride, on_all_cores);
        if (!choleskyInPlace(panel, columns, stride)) {
            failed_ = true;
            return;
        }
        const bool share = on_all_cores && 1.0 * rows * rows * columns > shared_work;
        const int strips = share ? (rows + strip - 1) / strip : 1;
        Number* below = panel + columns;
        forEachStrip(strips, rows, [&](int first, int last) {
            divideByTransposed(panel, columns, stride, below + first, last - first, stride);
        });
        forEachStrip(strips, rows, [&](int first, int last) {
            const int width = last - first;
            Number* target = update + 1L * first * rows + first;
            setToSquare(below + first, width, columns, stride, target, rows);
            if (last < rows)
                setToProduct(below + last, rows - last, below + first, width, columns, stride, target + width,
                             rows);
        });
        for (const int child : children)
            addUpdate(child, front, columns, columns + rows, update, rows, on_all_cores);
        popUpdates(children, stacks, 1 - own);
    }

    template <class Work>
    static void forEachStrip(int strips, int total, const Work& work) {
        if (total == 0) return;
        if (strips == 1) return work(0, total);
        forEachChunk(strips, [&](int s) { work(s * strip, std::min(total, (s + 1) * strip)); });
    }

    /// Puts a front's entries of A into its panel, which is zero.
    void takeEntries(int front, Number* panel, std::vector<int>& local_row) {
        const int first = fronts_.first_column[front], behind = fronts_.first_column[front + 1];
        const int stride = to_.stride(front);
        for (int column = first; column < behind; ++column) local_row[column] = column - first;
        int height = behind - first;
        for (const int row : fronts_.rows[front]) local_row[row] = height++;
        for (int column = first; column < behind; ++column) {
            const int vertex = fronts_.order[column];
            Number* target = panel + 1L * (column - first) * block_ * stride;
            takeBlock(vertex, 0, false, target + (column - first) * block_, stride);
            for (int k = 0; k < block_; ++k)
                target[1L * k * stride + (column - first) * block_ + k] += static_cast<Number>(shift_);
            for (int e = graph_.starts[vertex]; e < graph_.starts[vertex + 1]; ++e) {
                const int other = graph_.neighbours[e], row = fronts_.place[other];
                if (row > column)
                    takeBlock(std::min(vertex, other), graph_.positions[e], other < vertex,
                              target + local_row[row] * block_, stride);
            }
        }
    }

    /// Copies the block at a place in a block column of A.
    void takeBlock(int column, int position, bool transposed, Number* target, int stride) const {
        for (int j = 0; j < block_; ++j) {
            const double* source = matrix_.column(column, j) + position * block_;
            for (int i = 0; i < block_; ++i)
                target[transposed ? i * stride + j : j * stride + i] = static_cast<Number>(source[i]);
        }
    }

    /// Rows that lie next to each other in a child's update and in its parent's front, in unknowns.
    struct Piece {
        int in_child, in_parent, length;
    };

    std::vector<Piece> piecesOf(int child, int parent) const {
        std::vector<Piece> pieces;
        const int first = fronts_.first_column[parent], behind = fronts_.first_column[parent + 1];
        const std::vector<int>& parent_rows = fronts_.rows[parent];
        int from = 0, in_rows = 0;
        for (const int row : fronts_.rows[child]) {
            int to = row - first;
            if (row >= behind) {
                while (parent_rows[in_rows] != row) ++in_rows;
                to = behind - first + in_rows;
            }
            if (!pieces.empty() && pieces.back().in_parent + pieces.back().length == to * block_)
                pieces.back().length += block_;
            else
                pieces.push_back({from * block_, to * block_, block_});
            ++from;
        }
        return pieces;
    }

    /// Adds what a child left behind to the columns from `first` to below `last` of the front above it.
    /// `target` is where the front's entry (first, first) lies.
    void addUpdate(int child, int parent, int first, int last, Number* target, int stride,
                   bool on_all_cores) const {
        const std::vector<Piece> pieces = piecesOf(child, parent);
        const int size = to_.rowCount(child);
        const Number* source = updates_[child];
        const auto addColumns = [&](int chunk, int chunks) {
            for (std::size_t piece = 0; piece < pieces.size(); ++piece)
                for (int k = 0; k < pieces[piece].length; ++k) {
                    const int from = pieces[piece].in_child + k, to = pieces[piece].in_parent + k;
                    if (to < first || to >= last || from / 16 % chunks != chunk) continue;
                    addColumn(pieces, piece, k, source + 1L * from * size,
                              target + 1L * (to - first) * stride, first);
                }
        };
        constexpr double shared_sums = 2e5;
        if (!on_all_cores || 1.0 * size * size < shared_sums) return addColumns(0, 1);
        // Columns go to different places, so any core may take any of them.
        constexpr int chunks = 8;
        forEachChunk(chunks, [&](int chunk) { addColumns(chunk, chunks); });
    }

    /// Adds one column of a child's update from row `begin` of a piece on; `to`: the parent's column from its
    /// row `first_row` on.
    static void addColumn(const std::vector<Piece>& pieces, std::size_t piece, int begin, const Number* from,
                          Number* to, int first_row) {
        for (; piece < pieces.size(); ++piece, begin = 0) {
            const Number* source = from + pieces[piece].in_child;
            const int shift = pieces[piece].in_parent - first_row;
            for (int i = begin; i < pieces[piece].length; ++i) to[shift + i] += source[i];
        }
    }

    /// The updates of children in the same run lie on top of their stack.
    void popUpdates(const std::vector<int>& children, Stacks& stacks, int parity) const {
        const Number* begin = stacks.memory[parity].data();
        const Number* end = begin + stacks.memory[parity].size();
        for (const int child : children)
            if (updates_[child] >= begin && updates_[child] < end && to_.rowCount(child) > 0)
                stacks.used[parity] -= static_cast<std::size_t>(to_.rowCount(child)) * to_.rowCount(child);
    }

    MultifrontalFactor& to_;
    const FrontTree& fronts_;
    const int block_;
    const BlockGraph& graph_;
    const BlockMatrix& matrix_;
    const double shift_;
    std::vector<Number*> updates_;  // per front
    std::atomic<bool> failed_{false};
};

template <class Number>
MultifrontalFactor<Number>::MultifrontalFactor(const BlockGraph& graph, const EliminationTree& tree,
                                               int block_size)
    : block_(block_size), fronts_(graph, tree, block_size), schedule_(fronts_, block_size) {
    panel_starts_.assign(1, 0);
    for (int f = 0; f < fronts_.count(); ++f)
        panel_starts_.push_back(panel_starts_.back() + static_cast<std::size_t>(columnCount(f)) *
                                                           static_cast<std::size_t>(stride(f)));
}

template <class Number>
bool MultifrontalFactor<Number>::factor(const BlockGraph& graph, const BlockMatrix& matrix, double shift) {
    values_ = {};
    values_ = BigBuffer<Number>(panel_starts_.back());
    return Elimination(*this, graph, matrix, shift).run();
}

template <class Number>
double MultifrontalFactor<Number>::reciprocalCondition() const {
    double least = INFINITY, largest = 0;
    for (int f = 0; f < fronts_.count(); ++f)
        for (int j = 0; j < columnCount(f); ++j) {
            const double diagonal = panel(f)[1L * j * stride(f) + j];
            if (!(diagonal > 0) || !std::isfinite(diagonal)) return 0;
            least = std::min(least, diagonal);
            largest = std::max(largest, diagonal);
        }
    return largest > 0 ? std::pow(least / largest, 2) : 0;
}

template <class Number>
double MultifrontalFactor<Number>::smallestPivotShare(const std::vector<double>& diagonal) const {
    double least = INFINITY;
    for (int f = 0; f < fronts_.count(); ++f)
        for (int j = 0; j < columnCount(f); ++j) {
            const int vertex = fronts_.order[fronts_.first_column[f] + j / block_];
            const double root = panel(f)[1L * j * stride(f) + j];
            least = std::min(least, root * root / diagonal[vertex * block_ + j % block_]);
        }
    return least;
}

template class MultifrontalFactor<float>;
template class MultifrontalFactor<double>;

}  // namespace sherd
