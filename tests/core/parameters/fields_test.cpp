#include <gtest/gtest.h>
#include <sherd/fields.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace sherd;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Range, SaysInWordsWhatItTakes) {
    EXPECT_EQ(Range().text(), "finite");
    EXPECT_EQ(Range::positive("Pa").text(), "positive, in Pa");
    EXPECT_EQ(Range::atLeast(0, "s").text(), "0 or positive, in s");
    EXPECT_EQ(Range::atLeast(2).text(), "at least 2");
    EXPECT_EQ(Range::between(1, 6, "cells").text(), "between 1 and 6 cells");
    EXPECT_EQ(Range::between(0, 6).inSteps(2).text(), "0, 2, 4 or 6");
    EXPECT_EQ(Range::fractionOf("fraction of the wall").text(),
              "above 0 and at most 1 (fraction of the wall)");
    EXPECT_EQ(Range::positive("Pa").orSpecial(infinity, "never crushed").text(),
              "infinity (never crushed) or positive, in Pa");
}

TEST(Range, TakesItsEndsUnlessTheyAreOpen) {
    const Range closed = Range::between(1, 2);
    EXPECT_TRUE(closed.allows(1) && closed.allows(2));
    EXPECT_FALSE(closed.allows(0.999) || closed.allows(2.001));
    Range open = closed;
    open.open_below = open.open_above = true;
    EXPECT_FALSE(open.allows(1) || open.allows(2));
    EXPECT_TRUE(open.allows(1.5));
    EXPECT_EQ(open.text(), "above 1 and below 2");
    EXPECT_FALSE(Range().allows(infinity) || Range().allows(std::numeric_limits<double>::quiet_NaN()));
    const Range special = closed.orSpecial(infinity, "none");
    EXPECT_TRUE(special.allows(infinity));
    EXPECT_FALSE(special.allows(-infinity));
    const Range even = Range::between(0, 6).inSteps(2);
    EXPECT_TRUE(even.allows(4));
    EXPECT_FALSE(even.allows(3) || even.allows(8));
}

// How many members an aggregate has: as many as it can be made of. C++ 17 cannot name them.
struct Anything {
    template <class T>
    operator T() const;
};
template <class Struct, std::size_t... I>
auto madeOf(std::index_sequence<I...>) -> decltype(void(Struct{(void(I), Anything())...}), std::true_type());
template <class Struct>
std::false_type madeOf(...);

template <class Struct, std::size_t count = 64>
constexpr std::size_t memberCount() {
    if constexpr (decltype(madeOf<Struct>(std::make_index_sequence<count>()))::value)
        return count;
    else
        return memberCount<Struct, count - 1>();
}

template <class Struct>
std::size_t visitedCount() {
    Struct visited;
    std::size_t count = 0;
    visitFields(visited, [&](const Field&, auto&) { ++count; });
    return count;
}

TEST(Fields, EveryMemberHasItsLine) {
    EXPECT_EQ(visitedCount<Material>(), memberCount<Material>());
    EXPECT_EQ(visitedCount<SamplingSettings>(), memberCount<SamplingSettings>());
    EXPECT_EQ(visitedCount<StressSettings>(), memberCount<StressSettings>());
    EXPECT_EQ(visitedCount<ContactSettings>(), memberCount<ContactSettings>());
    EXPECT_EQ(visitedCount<GuideField>() + 1, memberCount<GuideField>()) << "all but `custom`";
    EXPECT_EQ(visitedCount<StrengthSettings>() + 1, memberCount<StrengthSettings>()) << "all but `field`";
    EXPECT_EQ(visitedCount<FractureSettings>(), memberCount<FractureSettings>());
    EXPECT_EQ(visitedCount<Settings>(), memberCount<Settings>());
}

/// Spoils the fields one after the other and expects `validate` to name each.
template <class Struct>
void expectChecked() {
    Struct fields;
    visitFields(fields, [&](const Field& field, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>) {
            const Value kept = value;
            value = static_cast<Value>(field.range.least - 2);
            EXPECT_NE(fields.validate().error().find(field.name + std::string(" is ")), std::string::npos)
                << field.name << ": " << fields.validate().error();
            EXPECT_NE(fields.validate().error().find(field.range.text()), std::string::npos) << field.name;
            value = kept;
        }
    });
    EXPECT_EQ(fields.validate().error(), "");
}

TEST(Fields, EveryRangeIsChecked) {
    expectChecked<Material>();
    expectChecked<SamplingSettings>();
    expectChecked<StressSettings>();
    expectChecked<StrengthSettings>();
    expectChecked<ContactSettings>();
    expectChecked<GuideField>();
    expectChecked<FractureSettings>();
}

TEST(Fields, PathsLeadThroughTheParts) {
    Settings settings;
    std::vector<std::string> paths;
    visitPaths(settings, [&](const std::string& path, const Field&, const auto&) { paths.push_back(path); });
    EXPECT_EQ(paths.front(), "sampling.spacing_m");
    EXPECT_NE(std::find(paths.begin(), paths.end(), "fracture.guide.cost_along"), paths.end());
    EXPECT_EQ(std::find(paths.begin(), paths.end(), "fracture.guide"), paths.end()) << "it has fields itself";
}

TEST(EnumNames, LeadToTheirValues) {
    EXPECT_STREQ(nameOf(Basis::cubic), "cubic");
    EXPECT_EQ(valueNamed<Basis>("cubic"), Basis::cubic);
    EXPECT_FALSE(valueNamed<Basis>("quintic"));
    EXPECT_STREQ(nameOf(GuideField::Kind::custom), "custom");
    EXPECT_FALSE(valueNamed<GuideField::Kind>("custom")) << "a file cannot give the function";
    EXPECT_EQ(listOf(namesInFiles<GuideField::Kind>()), "none, constant, radial");
}

}  // namespace
