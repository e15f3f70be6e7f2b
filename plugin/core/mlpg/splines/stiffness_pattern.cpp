#include "core/mlpg/splines/stiffness_pattern.h"

#include <algorithm>

namespace sherd {
namespace {

std::vector<int> functionsOf(const SplineSpace& space, int part) {
    std::vector<int> list;
    for (const int raw : space.raw_of[part])
        for (const SplineTies::Term& term : space.termsOf(raw)) list.push_back(term.function);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

}  // namespace

StiffnessPattern::StiffnessPattern(const SplineSpace& space)
    : functions_of_part(space.raw_of.size()), rows_of_column(space.function_count) {
    std::vector<std::vector<int>> parts_of(space.function_count);
    for (size_t part = 0; part < functions_of_part.size(); ++part) {
        functions_of_part[part] = functionsOf(space, static_cast<int>(part));
        for (const int function : functions_of_part[part])
            parts_of[function].push_back(static_cast<int>(part));
    }
    std::vector<int> seen(space.function_count, -1);
    for (int column = 0; column < space.function_count; ++column) {
        std::vector<int>& rows = rows_of_column[column];
        for (const int part : parts_of[column])
            for (const int row : functions_of_part[part]) {
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
