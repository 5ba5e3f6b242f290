// Writes a small store to start the fuzzer from: store_seed FILE

#include <cstdio>
#include <filesystem>

#include "verification/store/store.hpp"

using namespace porowave::verification;

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("store_seed: expected FILE\n", stderr);
    return 2;
  }
  std::filesystem::remove(words[1]);
  Store store = Store::create_or_open(words[1]);
  store.add(current_provenance());
  std::vector<Record> rows(3);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].id = std::string(32, static_cast<char>('a' + k));
    rows[k].specification = "[time]\nend = 1.0\n";
    rows[k].status = static_cast<CaseStatus>(k);
    rows[k].measures.assign(measure_names().size(), 0.5);
  }
  store.add(rows);
  return 0;
}
