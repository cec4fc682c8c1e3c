# cmake -DOUTPUT=x.cpp -DFILES=a|b -P embed.cmake: writes committed_sets(), which holds the bytes of the files.
string(REPLACE | ";" files "${FILES}")
set(arrays "")
set(entries "")
set(number 0)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "((0x..,)(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "const unsigned char kSet${number}[] = {\n${bytes}};\n")
  string(APPEND entries "      {\"${name}\", {reinterpret_cast<const char*>(kSet${number}), sizeof(kSet${number})}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"testbench/regression/committed_sets.h\"
namespace cbvh::testbench {
namespace {
${arrays}}  // namespace
std::vector<CommittedSet> committed_sets() {
  return {
${entries}  };
}
}  // namespace cbvh::testbench
")
