// The part of OpenGL 3.3 core that is used here: types, constants and functions, which are looked up at run
// time. Source: The OpenGL Graphics System, a Specification, Version 3.3 (Core Profile), Khronos 2010; the
// numbers are those of its registry.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hair::gl {

using Enum = unsigned int;
using Name = unsigned int;  // of a buffer, a texture, a program ...

inline constexpr Enum kTriangles = 0x0004, kTriangleStrip = 0x0005;
inline constexpr Enum kDepthBufferBit = 0x0100, kColourBufferBit = 0x4000;
inline constexpr Enum kOne = 1;
inline constexpr Enum kBlend = 0x0BE2, kDepthTest = 0x0B71, kPrimitiveRestart = 0x8F9D;
inline constexpr Enum kUnsignedByte = 0x1401, kUnsignedInt = 0x1405, kFloat = 0x1406;
inline constexpr Enum kRgba = 0x1908, kDepthComponent = 0x1902;
inline constexpr Enum kRgba8 = 0x8058, kRgba16F = 0x881A, kDepthComponent24 = 0x81A6;
inline constexpr Enum kTexture2D = 0x0DE1, kTexture0 = 0x84C0;
inline constexpr Enum kMinFilter = 0x2801, kMagFilter = 0x2800, kWrapS = 0x2802, kWrapT = 0x2803;
inline constexpr Enum kNearest = 0x2600, kClampToEdge = 0x812F;
inline constexpr Enum kFramebuffer = 0x8D40, kFramebufferComplete = 0x8CD5;
inline constexpr Enum kColourAttachment0 = 0x8CE0, kDepthAttachment = 0x8D00, kNone = 0;
inline constexpr Enum kArrayBuffer = 0x8892, kElementArrayBuffer = 0x8893;
inline constexpr Enum kStreamDraw = 0x88E0, kStaticDraw = 0x88E4;
inline constexpr Enum kVertexShader = 0x8B31, kFragmentShader = 0x8B30;
inline constexpr Enum kCompileStatus = 0x8B81, kLinkStatus = 0x8B82;
inline constexpr Enum kRenderer = 0x1F01, kVersion = 0x1F02;
inline constexpr Enum kNoError = 0;

// X(result, name, arguments), without the prefix gl.
#define HAIR_GL_FUNCTIONS(X)                                                           \
  X(void, ActiveTexture, (Enum))                                                       \
  X(void, AttachShader, (Name, Name))                                                  \
  X(void, BindBuffer, (Enum, Name))                                                    \
  X(void, BindFramebuffer, (Enum, Name))                                               \
  X(void, BindTexture, (Enum, Name))                                                   \
  X(void, BindVertexArray, (Name))                                                     \
  X(void, BlendFunc, (Enum, Enum))                                                     \
  X(void, BufferData, (Enum, std::ptrdiff_t, const void*, Enum))                       \
  X(Enum, CheckFramebufferStatus, (Enum))                                              \
  X(void, Clear, (unsigned))                                                           \
  X(void, ClearColor, (float, float, float, float))                                    \
  X(void, CompileShader, (Name))                                                       \
  X(Name, CreateProgram, ())                                                           \
  X(Name, CreateShader, (Enum))                                                        \
  X(void, DeleteShader, (Name))                                                        \
  X(void, DepthMask, (unsigned char))                                                  \
  X(void, Disable, (Enum))                                                             \
  X(void, DrawArrays, (Enum, int, int))                                                \
  X(void, DrawBuffer, (Enum))                                                          \
  X(void, DrawElements, (Enum, int, Enum, const void*))                                \
  X(void, Enable, (Enum))                                                              \
  X(void, EnableVertexAttribArray, (unsigned))                                         \
  X(void, Finish, ())                                                                  \
  X(void, FramebufferTexture2D, (Enum, Enum, Enum, Name, int))                         \
  X(void, GenBuffers, (int, Name*))                                                    \
  X(void, GenFramebuffers, (int, Name*))                                               \
  X(void, GenTextures, (int, Name*))                                                   \
  X(void, GenVertexArrays, (int, Name*))                                               \
  X(Enum, GetError, ())                                                                \
  X(void, GetProgramInfoLog, (Name, int, int*, char*))                                 \
  X(void, GetProgramiv, (Name, Enum, int*))                                            \
  X(void, GetShaderInfoLog, (Name, int, int*, char*))                                  \
  X(void, GetShaderiv, (Name, Enum, int*))                                             \
  X(const unsigned char*, GetString, (Enum))                                           \
  X(int, GetUniformLocation, (Name, const char*))                                      \
  X(void, LinkProgram, (Name))                                                         \
  X(void, PrimitiveRestartIndex, (unsigned))                                           \
  X(void, ReadBuffer, (Enum))                                                          \
  X(void, ReadPixels, (int, int, int, int, Enum, Enum, void*))                         \
  X(void, ShaderSource, (Name, int, const char* const*, const int*))                   \
  X(void, TexImage2D, (Enum, int, int, int, int, int, Enum, Enum, const void*))        \
  X(void, TexParameteri, (Enum, Enum, int))                                            \
  X(void, Uniform1f, (int, float))                                                     \
  X(void, Uniform1i, (int, int))                                                       \
  X(void, Uniform2f, (int, float, float))                                              \
  X(void, Uniform3f, (int, float, float, float))                                       \
  X(void, Uniform4f, (int, float, float, float, float))                                \
  X(void, UniformMatrix4fv, (int, int, unsigned char, const float*))                   \
  X(void, UseProgram, (Name))                                                          \
  X(void, VertexAttribPointer, (unsigned, int, Enum, unsigned char, int, const void*)) \
  X(void, Viewport, (int, int, int, int))

struct Functions {
#define HAIR_GL_MEMBER(result, name, arguments) result(*name) arguments = nullptr;
  HAIR_GL_FUNCTIONS(HAIR_GL_MEMBER)
#undef HAIR_GL_MEMBER
};

}  // namespace hair::gl
