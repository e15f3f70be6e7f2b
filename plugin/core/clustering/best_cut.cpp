#include "core/clustering/best_cut.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/numerics/hashed_random.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double flat = 0.8;      // share of the axes along one direction from which on a part is a flat wall
constexpr double mode_one = 0.2;  // shear in a crack, relative to the tension, that halves its worth
constexpr double variety = 0.1;   // how much worse a plane may be and still be taken
constexpr int most_bins = 24;
constexpr double bin_width = 1.2;  // particle spacings

class Search {
  public:
    Search(const std::vector<CutSample>& samples, double spacing, std::uint64_t seed, std::uint64_t counter)
        : samples_(samples), spacing_(spacing), seed_(seed), counter_(counter) {
        double pieces = 0;
        Vec3 sum = Vec3::Zero();
        for (const CutSample& s : samples) {
            pieces += s.pieces;
            sum += s.pieces * s.position;
        }
        const Vec3 mean = sum / pieces;
        for (const CutSample& s : samples) {
            const Vec3 off = s.position - mean;
            spread_ += s.pieces / pieces * off * off.transpose();
            facing_ += s.pieces / pieces * s.axis * s.axis.transpose();
        }
    }

    std::optional<CrackPlane> run() {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(facing_);
        if (solver.eigenvalues()[2] > flat)
            tryWithin(solver.eigenvectors());
        else
            tryAll();
        if (!(best_ > 0)) return {};
        return plane_;
    }

  private:
    double random(int component) const {
        return hashedRandom(seed_, 32 * counter_ + static_cast<std::uint64_t>(component / 4),
                            static_cast<std::uint64_t>(component % 4));
    }

    void tryWithin(const Mat3& frame) {
        constexpr int directions = 10, finer = 2;
        const Vec3 u = frame.col(0), v = frame.col(1);
        double step = pi / directions, middle = pi * random(0);
        for (int d = 0; d < directions; ++d) tryAngle(u, v, middle + d * step);
        for (int round = 0; round < finer; ++round) {
            step /= 3;
            middle = best_angle_;
            for (const int d : {-1, 1}) tryAngle(u, v, middle + d * step);
        }
    }

    void tryAngle(const Vec3& u, const Vec3& v, double angle) {
        if (tryNormal(std::cos(angle) * u + std::sin(angle) * v)) best_angle_ = angle;
    }

    void tryAll() {
        constexpr int directions = 20, finer = 2, around = 5;
        const Vec3 axis = Vec3(random(0), random(1), random(2) + 1e-3).normalized();
        const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
        for (int d = 0; d < directions; ++d) {  // Fibonacci's half sphere
            const double z = (d + 0.5) / directions, r = std::sqrt(1 - z * z),
                         angle = d * pi * (3 - std::sqrt(5.0));
            tryNormal(r * std::cos(angle) * u + r * std::sin(angle) * v + z * axis);
        }
        double step = 0.25;
        for (int round = 0; round < finer && best_ > 0; ++round, step /= 2) {
            const Vec3 n = plane_.normal, a = n.unitOrthogonal(), b = n.cross(a);
            for (int d = 0; d < around; ++d) {
                const double angle = 2 * pi * d / around;
                tryNormal((n + step * (std::cos(angle) * a + std::sin(angle) * b)).normalized());
            }
        }
    }

    struct Bin {
        double pieces = 0, volume = 0, stretched = 0, opening = 0;
    };

    bool tryNormal(const Vec3& normal) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const CutSample& s : samples_) {
            const double at = normal.dot(s.position);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        if (!(high > low)) return false;
        const int count = std::clamp(static_cast<int>((high - low) / (bin_width * spacing_)), 2, most_bins);
        const double per_m = count / (high - low);
        std::array<Bin, most_bins + 1> bins{};  // about low + k / per_m
        for (const CutSample& s : samples_) {
            const double at = (normal.dot(s.position) - low) * per_m;
            const int k = std::min(static_cast<int>(at), count - 1);
            const Vec3 metric_n = s.metric * normal;
            const double along = normal.dot(metric_n), size = s.metric.trace(),
                         shear = (metric_n.squaredNorm() - along * along) / (size * size);
            const double stretched = s.volume * std::sqrt(along),
                         opening = s.volume / (1 + shear / (mode_one * mode_one));
            for (const auto& [bin, share] : {std::make_pair(k, k + 1 - at), std::make_pair(k + 1, at - k)}) {
                bins[bin].pieces += share * s.pieces;
                bins[bin].volume += share * s.volume;
                bins[bin].stretched += share * stretched;
                bins[bin].opening += share * opening;
            }
        }
        return tryOffsets(normal, bins, count, low, 1 / per_m);
    }

    bool tryOffsets(const Vec3& normal, const std::array<Bin, most_bins + 1>& bins, int count, double low,
                    double width) {
        double all = 0, before = 0;
        for (const Bin& bin : bins) all += bin.pieces;
        const double wide = std::sqrt(normal.dot(spread_ * normal)) * (1 + variety * random(++tried_));
        bool better = false;
        for (int k = 0; k <= count; ++k) {
            const double share = (before + 0.5 * bins[k].pieces) / all;
            before += bins[k].pieces;
            if (k == 0 || k == count || !(bins[k].volume > 0)) continue;
            const double good = wide * bins[k].stretched / bins[k].volume * bins[k].opening / bins[k].volume *
                                4 * share * (1 - share);
            if (!(good > best_)) continue;
            best_ = good;
            plane_ = {normal, low + k * width};
            better = true;
        }
        return better;
    }

    const std::vector<CutSample>& samples_;
    double spacing_;
    std::uint64_t seed_, counter_;
    Mat3 spread_ = Mat3::Zero(), facing_ = Mat3::Zero();
    int tried_ = 3;
    double best_ = 0, best_angle_ = 0;
    CrackPlane plane_;
};

}  // namespace

std::optional<CrackPlane> bestCut(const std::vector<CutSample>& samples, double spacing, std::uint64_t seed,
                                  std::uint64_t counter) {
    if (samples.size() < 2) return {};
    return Search(samples, spacing, seed, counter).run();
}

}  // namespace sherd
