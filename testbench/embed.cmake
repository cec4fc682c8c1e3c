# cmake -DOUTPUT=x.cpp -DFILES=a|b -DHEADER=h -DTYPE=T -DFUNCTION=f -P embed.cmake: writes f(), which gives a T for each file: its name
# and its bytes. HEADER declares both.
string(REPLACE | ";" files "${FILES}")
set(arrays "")
set(entries "")
set(number 0)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "((0x..,)(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?(0x..,)?)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "const unsigned char kFile${number}[] = {\n${bytes}};\n")
  string(APPEND entries "      {\"${name}\", {reinterpret_cast<const char*>(kFile${number}), sizeof(kFile${number})}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"
namespace cbvh::testbench {
namespace {
${arrays}}  // namespace
std::vector<${TYPE}> ${FUNCTION}() {
  return {
${entries}  };
}
}  // namespace cbvh::testbench
")
