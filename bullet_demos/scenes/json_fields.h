#pragma once

#include <sherd/types.h>

#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace demo {

/// A key or a value of a scene file that cannot be taken, as a sentence that begins with the path of the key.
/// Thrown by what reads the parts of a scene, caught in `readScene`.
struct BadKey {
    std::string sentence;
};

/// The numbers that a key takes.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    const char* unit = "";
};

/// An object of a scene file. Every `read` takes over what the object says and leaves the value alone where
/// it says nothing; the keys that were asked for are those there are.
class Fields {
  public:
    Fields(const nlohmann::json& object, std::string path);

    bool has(const char* name) const { return object_.contains(name); }
    std::string pathOf(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }
    const std::string& path() const { return path_; }

    void read(const char* name, double& value, const Range& range = {});
    void read(const char* name, int& value, const Range& range = {});
    void read(const char* name, bool& value);
    void read(const char* name, std::string& value);
    void read(const char* name, sherd::Vec3& value, const Range& range = {});

    /// One of a few words.
    template <class Choice>
    void read(const char* name, Choice& value,
              std::initializer_list<std::pair<const char*, Choice>> choices) {
        std::string word, words;
        read(name, word);
        for (const auto& [known, choice] : choices) {
            if (word == known) value = choice;
            if (has(name) && word == known) return;
            words += (words.empty() ? "" : ", ") + std::string(known);
        }
        if (has(name)) fail(name, "is \"" + word + "\"; choose one of: " + words);
    }

    /// Calls `read_part(Fields&)` on the object of that name, if there is one.
    template <class Read>
    void object(const char* name, const Read& read_part) {
        if (const nlohmann::json* part = find(name)) readObject(*part, pathOf(name), read_part);
    }

    /// Calls `read_item(Fields&)` on every object in the list of that name, if there is one.
    template <class Read>
    void list(const char* name, const Read& read_item) {
        const nlohmann::json* items = find(name);
        if (!items) return;
        if (!items->is_array()) fail(name, "must be a list in brackets, not " + items->dump());
        for (std::size_t i = 0; i < items->size(); ++i)
            readObject((*items)[i], pathOf(name) + "[" + std::to_string(i) + "]", read_item);
    }

    /// The value of that name as it stands; nullptr if there is none.
    const nlohmann::json* find(const char* name);

    /// Calls `read_part(Fields&)` on an object and refuses keys that it did not ask for.
    template <class Read>
    static void readObject(const nlohmann::json& object, const std::string& path, const Read& read_part) {
        Fields fields(object, path);
        read_part(fields);
        fields.refuseUnknown();
    }

    /// `what` goes on from the path of the key and has no full stop.
    [[noreturn]] void fail(const std::string& name, const std::string& what) const;

  private:
    void refuseUnknown() const;

    const nlohmann::json& object_;
    std::string path_;
    std::vector<std::string> known_;
};

}  // namespace demo
