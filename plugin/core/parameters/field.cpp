#include <sherd/field.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace sherd {

namespace {

/// "0, 2, 4 or 6".
std::string listOfSteps(const Range& range) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    for (double value = range.least; value <= range.most; value += range.step) {
        if (value > range.least) text << (value + range.step > range.most ? " or " : ", ");
        text << value;
    }
    return text.str();
}

std::string limitsOf(const Range& range) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    const bool below = std::isfinite(range.least), above = std::isfinite(range.most);
    if (below && above && !range.open_below && !range.open_above)
        text << "between " << range.least << " and " << range.most;
    else if (below && !above && range.least == 0)
        text << (range.open_below ? "positive" : "0 or positive");
    else if (below || above) {
        if (below) text << (range.open_below ? "above " : "at least ") << range.least;
        if (below && above) text << " and ";
        if (above) text << (range.open_above ? "below " : "at most ") << range.most;
    } else
        text << "finite";
    if (*range.unit) text << (below && above ? " " : ", in ") << range.unit;
    return text.str();
}

}  // namespace

bool Range::allows(double value) const {
    if (value == special) return true;
    if (!std::isfinite(value)) return false;
    if (open_below ? value <= least : value < least) return false;
    if (open_above ? value >= most : value > most) return false;
    return step == 0 || std::remainder(value - least, step) == 0;
}

std::string Range::text() const {
    std::string words = step > 0 ? listOfSteps(*this) : limitsOf(*this);
    if (*remark) words += std::string(" (") + remark + ")";
    if (std::isnan(special)) return words;
    std::ostringstream other;
    other.imbue(std::locale::classic());
    if (std::isinf(special))
        other << "infinity";
    else
        other << special;
    return other.str() + " (" + special_meaning + ") or " + words;
}

bool isAmong(const std::vector<std::string>& names, const std::string& text) {
    return names.empty() || std::find(names.begin(), names.end(), text) != names.end();
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace sherd
