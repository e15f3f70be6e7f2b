#include "core/mlpg/splines/stiffness_pattern.h"

#include <algorithm>

namespace sherd {
namespace {

/// Unknown functions that raw ones stand for, ascending.
std::vector<int> unknownFunctions(const SplineSpace& space, const std::vector<int>& raw_functions) {
    std::vector<int> list;
    for (const int raw : raw_functions)
        for (const SplineTies::Term& term : space.termsOf(raw)) list.push_back(term.function);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

}  // namespace

StiffnessPattern::StiffnessPattern(const SplineSpace& space, const VolumetricProjection* projection)
    : rows_of_column(space.function_count) {
    for (const std::vector<int>& raw : space.raw_of)
        functions_of_part.push_back(unknownFunctions(space, raw));
    if (projection)
        for (const VolumetricProjection::MacroCell& cell : projection->cells())
            functions_of_macro_cell.push_back(unknownFunctions(space, cell.functions));
    // Those of a part are among those of its macro cell.
    const auto& sets = projection ? functions_of_macro_cell : functions_of_part;
    std::vector<std::vector<int>> sets_of(space.function_count);
    for (size_t set = 0; set < sets.size(); ++set)
        for (const int function : sets[set]) sets_of[function].push_back(static_cast<int>(set));
    std::vector<int> seen(space.function_count, -1);
    for (int column = 0; column < space.function_count; ++column) {
        std::vector<int>& rows = rows_of_column[column];
        for (const int set : sets_of[column])
            for (const int row : sets[set]) {
                if (row < column || seen[row] == column) continue;
                seen[row] = column;
                rows.push_back(row);
            }
        std::sort(rows.begin(), rows.end());
    }
}

SparseMatrix zeroStiffness(const StiffnessPattern& pattern) {
    SparseMatrix matrix;
    matrix.size = static_cast<int>(pattern.rows_of_column.size()) * 3;
    size_t entries = 0;
    for (const std::vector<int>& rows : pattern.rows_of_column) entries += 9 * rows.size();
    matrix.indices.reserve(entries);
    matrix.starts.assign(1, 0);
    for (const std::vector<int>& rows : pattern.rows_of_column)
        for (int k = 0; k < 3; ++k) {
            for (const int row : rows)
                for (int i = 0; i < 3; ++i) matrix.indices.push_back(3 * row + i);
            matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
        }
    matrix.values.assign(matrix.indices.size(), 0.0);
    return matrix;
}

SparseMatrix blockMatrix(const StiffnessPattern& pattern) {
    SparseMatrix blocks;
    blocks.size = static_cast<int>(pattern.rows_of_column.size());
    blocks.starts.assign(1, 0);
    for (const std::vector<int>& rows : pattern.rows_of_column) {
        blocks.indices.insert(blocks.indices.end(), rows.begin(), rows.end());
        blocks.starts.push_back(static_cast<int>(blocks.indices.size()));
    }
    return blocks;
}

}  // namespace sherd
