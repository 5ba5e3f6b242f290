// Any bytes as a store: read and merged, or refused by InputError or EnvironmentError.

#include <cstdint>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/store/store.hpp"

using namespace porowave;
using namespace porowave::verification;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchDirectory directory;
  const std::string name = directory.file("store");
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  for (const char* rest : {"-wal", "-shm"}) std::filesystem::remove(name + rest);
  try {
    const Store store = Store::open(name);
    for (const Record& row : store.all()) {
      if (row.measures.size() != measure_names().size()) __builtin_trap();
    }
    store.finished_ids();
    const std::string target = directory.file("target");
    std::filesystem::remove(target);
    Store::create_or_open(target).merge(name);
  } catch (const InputError&) {
  } catch (const EnvironmentError&) {
  }
  return 0;
}
