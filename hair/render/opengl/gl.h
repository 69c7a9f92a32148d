// The used part of OpenGL 3.3 core: types, constants and functions, which are looked up at run time. Source:
// The OpenGL Graphics System, a Specification, Version 3.3 (Core Profile), Khronos 2010; the numbers are from
// its registry.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hair::gl {

using Enum = unsigned int;
using Name = unsigned int;  // names a buffer, a texture, a program ...

inline constexpr Enum kTriangles = 0x0004, kTriangleStrip = 0x0005;
inline constexpr Enum kDepthBufferBit = 0x0100, kColourBufferBit = 0x4000;
inline constexpr Enum kOne = 1;
inline constexpr Enum kBlend = 0x0BE2, kDepthTest = 0x0B71, kPrimitiveRestart = 0x8F9D;
inline constexpr Enum kUnsignedByte = 0x1401, kUnsignedInt = 0x1405, kFloat = 0x1406;
inline constexpr Enum kRgba = 0x1908, kDepthComponent = 0x1902;
inline constexpr Enum kRgba8 = 0x8058, kRgba16F = 0x881A, kDepthComponent24 = 0x81A6;
inline constexpr Enum kRed = 0x1903, kR32F = 0x822E, kRgba32F = 0x8814;
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

// X(name without its prefix gl, type). Offsets into buffers are numbers here; OpenGL's own headers declare
// them as pointers.
#define HAIR_GL_FUNCTIONS(X)                                                         \
  X(ActiveTexture, void(Enum))                                                       \
  X(AttachShader, void(Name, Name))                                                  \
  X(BindBuffer, void(Enum, Name))                                                    \
  X(BindFramebuffer, void(Enum, Name))                                               \
  X(BindTexture, void(Enum, Name))                                                   \
  X(BindVertexArray, void(Name))                                                     \
  X(BlendFunc, void(Enum, Enum))                                                     \
  X(BufferData, void(Enum, std::ptrdiff_t, const void*, Enum))                       \
  X(CheckFramebufferStatus, Enum(Enum))                                              \
  X(Clear, void(unsigned))                                                           \
  X(CompileShader, void(Name))                                                       \
  X(CreateProgram, Name())                                                           \
  X(CreateShader, Name(Enum))                                                        \
  X(Disable, void(Enum))                                                             \
  X(DrawArrays, void(Enum, int, int))                                                \
  X(DrawBuffer, void(Enum))                                                          \
  X(DrawElements, void(Enum, int, Enum, const void*))                                \
  X(Enable, void(Enum))                                                              \
  X(EnableVertexAttribArray, void(unsigned))                                         \
  X(FramebufferTexture2D, void(Enum, Enum, Enum, Name, int))                         \
  X(GenBuffers, void(int, Name*))                                                    \
  X(GenFramebuffers, void(int, Name*))                                               \
  X(GenTextures, void(int, Name*))                                                   \
  X(GenVertexArrays, void(int, Name*))                                               \
  X(GetError, Enum())                                                                \
  X(GetProgramInfoLog, void(Name, int, int*, char*))                                 \
  X(GetProgramiv, void(Name, Enum, int*))                                            \
  X(GetShaderInfoLog, void(Name, int, int*, char*))                                  \
  X(GetShaderiv, void(Name, Enum, int*))                                             \
  X(GetString, const unsigned char*(Enum))                                           \
  X(GetUniformLocation, int(Name, const char*))                                      \
  X(LinkProgram, void(Name))                                                         \
  X(PrimitiveRestartIndex, void(unsigned))                                           \
  X(ReadBuffer, void(Enum))                                                          \
  X(ReadPixels, void(int, int, int, int, Enum, Enum, void*))                         \
  X(ShaderSource, void(Name, int, const char* const*, const int*))                   \
  X(TexImage2D, void(Enum, int, int, int, int, int, Enum, Enum, const void*))        \
  X(TexParameteri, void(Enum, Enum, int))                                            \
  X(Uniform1f, void(int, float))                                                     \
  X(Uniform1i, void(int, int))                                                       \
  X(Uniform2f, void(int, float, float))                                              \
  X(Uniform3f, void(int, float, float, float))                                       \
  X(Uniform4f, void(int, float, float, float, float))                                \
  X(UniformMatrix4fv, void(int, int, unsigned char, const float*))                   \
  X(UseProgram, void(Name))                                                          \
  X(VertexAttribPointer, void(unsigned, int, Enum, unsigned char, int, std::size_t)) \
  X(Viewport, void(int, int, int, int))

template <class Type>
using Pointer = Type*;

struct Functions {
#define HAIR_GL_MEMBER(name, type) Pointer<type> name = nullptr;
  HAIR_GL_FUNCTIONS(HAIR_GL_MEMBER)
#undef HAIR_GL_MEMBER
};

}  // namespace hair::gl
