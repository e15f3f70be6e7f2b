#pragma once

#include <sherd/fields.h>

#include <iterator>

#include "core/archive/archive.h"

namespace sherd {

/// Material and settings: all of their fields but functions.
template <class Archive, class Struct>
std::enable_if_t<has_fields<Struct>> archiveFields(Archive& to_or_from, Struct& fields) {
    visitFields(fields, [&](const Field&, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_enum_v<Value>)
            archiveEnum(to_or_from, value, std::size(enum_names<Value>));
        else
            archive(to_or_from, value);
    });
}

}  // namespace sherd
