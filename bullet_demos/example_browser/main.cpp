// Bullet's example browser with the scenes of this tree. It takes the browser's own options:
// --start_demo_name=,
// --width=, --height=, ...

#include <ExampleBrowser/OpenGLExampleBrowser.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "example_browser/example_table.h"

namespace {

/// What the browser asks for its tree.
class Entries : public ExampleEntries {
  public:
    void initExampleEntries() override {}
    void initOpenCLExampleEntries() override {}
    int getNumRegisteredExamples() override { return static_cast<int>(entries().size()); }
    CommonExampleInterface::CreateFunc* getExampleCreateFunc(int index) override {
        return entries()[index].create;
    }
    const char* getExampleName(int index) override { return entries()[index].name.c_str(); }
    const char* getExampleDescription(int index) override { return entries()[index].description.c_str(); }
    int getExampleOption(int index) override { return entries()[index].option; }

  private:
    static const std::vector<demo::BrowserEntry>& entries() { return demo::brittleFractureEntries(); }
};

}  // namespace

int main(int argc, char** argv) {
    using Clock = std::chrono::steady_clock;
    constexpr float longest_step_s = 0.1f;
    Entries entries;
    OpenGLExampleBrowser browser(&entries);
    if (!browser.init(argc, argv)) return 1;
    Clock::time_point before = Clock::now();
    while (!browser.requestedExit()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const Clock::time_point now = Clock::now();
        browser.update(std::min(longest_step_s, std::chrono::duration<float>(now - before).count()));
        before = now;
    }
    return 0;
}
