#include "core/mlpg/splines/part_ties.h"

#include <algorithm>

namespace sherd {

PartTies::PartTies(const SplineSpace& space, int part, const std::vector<int>& functions)
    : function_count_(functions.size()) {
    const std::vector<int>& raws = space.raw_of[part];
    for (size_t a = 0; a < raws.size(); ++a)
        for (const SplineTies::Term& term : space.termsOf(raws[a])) {
            const auto place = std::lower_bound(functions.begin(), functions.end(), term.function);
            terms_.push_back({static_cast<int>(a), static_cast<int>(place - functions.begin()), term.factor});
            identity_ = identity_ && terms_.back().own == terms_.back().unknown && term.factor == 1;
        }
    identity_ = identity_ && functions.size() == raws.size();
}

void PartTies::apply(Eigen::MatrixXd& matrix) const {
    if (identity_) return;
    const Eigen::MatrixXd by_columns = columns(matrix);
    const auto count = static_cast<long>(function_count_);
    matrix.setZero(count, count);
    for (long column = 0; column < count; ++column)
        for (const Term& term : terms_)
            matrix(term.unknown, column) += term.factor * by_columns(term.own, column);
}

Eigen::MatrixXd PartTies::columns(const Eigen::MatrixXd& matrix) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.rows(), static_cast<long>(function_count_));
    for (const Term& term : terms_) result.col(term.unknown) += term.factor * matrix.col(term.own);
    return result;
}

}  // namespace sherd
