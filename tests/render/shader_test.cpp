#include "render/shader.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/context.h"
#include "support/texts.h"

namespace regarment {
namespace {

constexpr std::string_view kVertex = "#version 450 core\nvoid main() { gl_Position = vec4(0); }\n";

std::string message_of(std::string_view fragment) {
  Context::of_this_thread();
  return refusal_of<Error>([&] { Shader("broken", kVertex, fragment); });
}

TEST(Shader, ErrorNamesFileAndLine) {
  const std::string message = message_of("#version 450 core\nvoid main() {\n  wrong();\n}\n");
  EXPECT_EQ(message.rfind("shaders/broken.frag:3: ", 0), 0U) << message;
}

TEST(Shader, ErrorIsOneLine) {
  EXPECT_EQ(message_of("#version 450 core\nnot a shader\n").find('\n'), std::string::npos);
}

TEST(Shader, BuiltInPairsCompile) {
  Context::of_this_thread();
  for (const char* name : {"mesh", "splat", "silhouette"}) EXPECT_NO_THROW(Shader{name}) << name;
}

TEST(Shader, RefusesUnknownNamesAndUniforms) {
  Context::of_this_thread();
  EXPECT_THROW(Shader("no_such_pair"), InvalidInput);
  EXPECT_THROW(Shader("mesh").set("no_such_uniform", 1.0F), InvalidInput);
}

TEST(Context, SaysWhatDraws) {
  EXPECT_NE(Context::of_this_thread().description().find("OpenGL 4.5"), std::string::npos);
}

TEST(Context, IsOnePerThread) {
  Context& mine = Context::of_this_thread();
  EXPECT_EQ(&mine, &Context::of_this_thread());
  EXPECT_THROW(Context(), InvalidInput);
}

}  // namespace
}  // namespace regarment
