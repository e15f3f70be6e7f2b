#include "fracture/kept_model.h"

#include "core/archive/byte_reader.h"
#include "core/archive/byte_writer.h"
#include "fracture/kept_model_archive.h"

namespace sherd {

KeptModel asKept(const KeptModel& made, const Material& material) {
    ByteWriter writer;
    KeptModel written = made, read;
    archiveModel(writer, material, written);
    ByteReader reader(writer.bytes().data(), writer.bytes().size());
    if (writer.good()) archiveModel(reader, material, read);
    return writer.good() && reader.good() ? read : made;
}

}  // namespace sherd
