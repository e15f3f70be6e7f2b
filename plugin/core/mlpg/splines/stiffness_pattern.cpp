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

BlockMatrix emptyMatrixOf(const StiffnessPattern& pattern) {
    BlockMatrix blocks;
    std::size_t count = 0;
    for (const std::vector<int>& rows : pattern.rows_of_column) count += rows.size();
    blocks.starts.reserve(pattern.rows_of_column.size() + 1);
    blocks.rows.reserve(count);
    for (const std::vector<int>& rows : pattern.rows_of_column) blocks.addColumn(rows);
    return blocks;
}

}  // namespace sherd
