#include "fracture/failed_if_thrown.h"

#include <exception>

#include "fracture/stage.h"

namespace sherd {

namespace {

void fail(BlowOutcome& outcome, const std::string& message) {
    outcome.outcome = Outcome::failed;
    outcome.message = message;
    outcome.fragments.clear();
}

}  // namespace

BlowOutcome failedIfThrown(const std::function<void(BlowOutcome&)>& stages) {
    BlowOutcome outcome;
    try {
        stages(outcome);
    } catch (const StageFailed& failure) {
        fail(outcome, failure.message);
    } catch (const std::exception& failure) {  // a field of the app, a library's check, no memory
        fail(outcome,
             std::string("The blow could not be worked out (") + failure.what() + "); the body stays whole.");
    } catch (...) {
        fail(outcome,
             "The blow could not be worked out: a strength field or guide field threw what is no "
             "std::exception; the body stays whole.");
    }
    return outcome;
}

}  // namespace sherd
