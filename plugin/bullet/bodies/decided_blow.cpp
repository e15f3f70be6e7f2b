#include "bullet/bodies/decided_blow.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <string>
#include <utility>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/stopwatch.h"
#include "fracture/decide_blow.h"
#include "fracture/failed_if_thrown.h"

namespace sherd {

namespace {

/// The one with most vertices first: it takes longest, and threads that are done with others help with it.
std::vector<int> largestFirst(const std::vector<Fragment>& fragments) {
    std::vector<int> order(fragments.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return fragments[a].solid->surface().vertices.size() > fragments[b].solid->surface().vertices.size();
    });
    return order;
}

std::vector<std::shared_ptr<const OwnedShape>> shapesOf(const std::vector<Fragment>& fragments,
                                                        const ShapeChoice& choice) {
    std::vector<std::shared_ptr<const OwnedShape>> shapes(fragments.size());
    const std::vector<int> order = largestFirst(fragments);
    forEachChunk(static_cast<int>(fragments.size()), [&](int i) {
        const int f = order[i];
        const Fragment& fragment = fragments[f];
        const btTransform frame = principalFrame(fragment.solid->moments()).body_from_asset;
        shapes[f] =
            std::make_shared<const OwnedShape>(makeShape(*fragment.solid, choice, fragment.boxes, frame));
    });
    return shapes;
}

}  // namespace

bool mayRunElsewhere(const BreakableSolid& solid, const FractureSettings& fracture) {
    return !solid.settings().strength.field && !fracture.guide.custom;
}

std::shared_ptr<DecidedBlow> DecidedBlow::make(BlowToDecide blow) {
    const std::shared_ptr<DecidedBlow> decided(new DecidedBlow);
    decided->may_run_elsewhere_ = mayRunElsewhere(*blow.solid, *blow.fracture);
    // An executor may keep the job for longer than anybody wants to know what comes of the blow.
    const std::weak_ptr<DecidedBlow> into = decided;
    decided->job_ = Job::make([blow = std::move(blow), into] {
        if (const auto wanted = into.lock()) decide(blow, *wanted);
    });
    return decided;
}

std::shared_ptr<DecidedBlow> DecidedBlow::decided(BlowOutcome outcome,
                                                  std::vector<std::shared_ptr<const OwnedShape>> shapes) {
    const std::shared_ptr<DecidedBlow> decided(new DecidedBlow);
    decided->outcome = std::move(outcome);
    decided->shapes = std::move(shapes);
    decided->job_ = Job::make([] {});
    decided->job_->doIfFree();
    return decided;
}

void DecidedBlow::decide(const BlowToDecide& blow, DecidedBlow& decided) {
    BlowOutcome outcome = failedIfThrown([&](BlowOutcome& out) {
        out.level = Level::full;  // of what throws
        out = solveBlow(*blow.solid, blow.blow, *blow.fracture, blow.seed, blow.earlier);
    });
    outcome.ms += blow.before;
    try {
        const AddedTime time(outcome.ms.bodies);
        decided.shapes = shapesOf(outcome.fragments, ShapeChoice(*blow.fracture));
    } catch (const std::exception& trouble) {
        outcome.outcome = Outcome::failed;
        outcome.fragments.clear();
        outcome.message = std::string("the fragments' collision shapes could not be made (") +
                          trouble.what() + "); the body stays whole";
    }
    decided.outcome = std::move(outcome);
}

void DecidedBlow::submit(const Executor& executor) {
    if (!may_run_elsewhere_ || !executor || std::exchange(submitted_, true)) return;
    job_->submit(executor);
}

void DecidedBlow::finish(double& waiting_ms) {
    if (std::exchange(finished_, true)) return;
    const Stopwatch watch;
    job_->finish();
    if (doneElsewhere()) waiting_ms += watch.milliseconds();
}

}  // namespace sherd
