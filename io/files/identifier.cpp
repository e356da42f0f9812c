#include "io/files/identifier.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace brdf::io {
namespace {

// The keywords of C++20, including the alternative tokens.
constexpr std::string_view kCppKeywords =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t "
    "char8_t class co_await co_return co_yield compl concept const const_cast consteval constexpr "
    "constinit continue decltype default delete do double dynamic_cast else enum explicit export extern "
    "false final float for friend goto if import inline int long module mutable namespace new noexcept "
    "not not_eq nullptr operator or or_eq override private protected public register reinterpret_cast "
    "requires return short signed sizeof static static_assert static_cast struct switch template this "
    "thread_local throw true try typedef typeid typename typeof union unsigned using virtual void "
    "volatile wchar_t while xor xor_eq";

// Names that <cmath>, <cstdint> and <cstring> declare at global scope, and names from other headers of C
// and POSIX, taken from the preprocessed headers of g++ 12 and clang 14. Names with the suffix of a type
// (sinf, sinl) are not listed.
constexpr std::string_view kCppTaken =
    "BUFSIZ EOF FILE INFINITY MAXFLOAT NAN NFDBITS NULL SNAN SNANF SNANF128 SNANF32 SNANF32X SNANF64 "
    "SNANF64X SNANL WCONTINUED WEXITED WNOHANG WNOWAIT WSTOPPED WUNTRACED a64l abort abs access acct acos "
    "acosh alarm aligned_alloc alloca arc4random arc4random_buf arc4random_uniform asctime asin asinh "
    "asprintf at_quick_exit atan atan2 atanh atexit atof atoi atol basename bcmp bcopy brdf brk bsearch "
    "btowc bzero calloc canonicalize canonicalize_file_name cbrt ceil chdir chown chroot clearenv "
    "clearerr clock close closefrom confstr copysign cos cosh crypt ctermid ctime cuserid daddl daemon "
    "daylight ddivl dfmal difftime div dmull dprintf drand48 drand48_data drem dsqrtl dsubl dup dup2 dup3 "
    "duplocale dysize eaccess ecvt endusershell environ erand48 erf erfc errno euidaccess execl execle "
    "execlp execv execve execveat execvp execvpe exit exp exp10 exp2 explicit_bzero expm1 fabs faccessat "
    "fadd fchdir fchown fchownat fclose fcloseall fcvt fd_mask fd_set fdatasync fdim fdiv fdopen feof "
    "ferror fexecve fflush ffma ffs ffsll fgetc fgetpos fgets fgetwc fgetws fileno finite flockfile floor "
    "fma fmax fmaximum fmaximum_mag fmaximum_mag_num fmaximum_num fmaxmag fmemopen fmin fminimum "
    "fminimum_mag fminimum_mag_num fminimum_num fminmag fmod fmul fopen fopencookie fork fpathconf "
    "fprintf fputc fputs fputwc fputws fread free freelocale freopen frexp fromfp fromfpx fscanf fseek "
    "fseeko fsetpos fsqrt fsub fsync ftell ftello ftruncate ftrylockfile funlockfile fwide fwprintf "
    "fwrite fwscanf gamma gcvt getc getchar getcwd getdate getdelim getdomainname getdtablesize getegid "
    "getentropy getenv geteuid getgid getgroups gethostid gethostname getline getloadavg getlogin getopt "
    "getpagesize getpass getpayload getpgid getpgrp getpid getppid getpt getresgid getresuid getsid "
    "getsubopt gettid getuid getusershell getw getwc getwchar getwd gmtime grantpt gsignal hypot i386 "
    "ilogb index initstate isalnum isalpha isascii isatty isblank iscanonical iscntrl isctype isdigit "
    "iseqsig isgraph isinff isinfl islower isnanf isnanl isprint ispunct issignaling isspace isupper "
    "isxdigit iszero itimerspec j0 j1 jn jrand48 kill killpg l64a labs lchown lcong48 lconv ldexp ldiv "
    "lgamma link linkat linux llabs lldiv llogb llrint llround localeconv localtime lockf log log10 log1p "
    "log2 logb longjmp lrand48 lrint lround lseek main malloc math_errhandling mblen mbrlen mbrtowc "
    "mbsinit mbsnrtowcs mbsrtowcs mbstowcs mbtowc memccpy memchr memcmp memcpy memfrob memmem memmove "
    "mempcpy memrchr memset mkdtemp mkostemp mkostemps mkstemp mkstemps mktemp mktime modf mrand48 nan "
    "nanosleep nearbyint newlocale nextafter nextdown nexttoward nextup nice nrand48 obstack on_exit "
    "optarg opterr optind optopt pathconf pause pclose perror pipe pipe2 popen posix_memalign "
    "posix_openpt pow pread printf profil pselect psiginfo psignal ptsname putc putchar putenv puts putw "
    "putwc putwchar pwrite qecvt qfcvt qgcvt qsort quick_exit raise rand random random_data rawmemchr "
    "read readlink readlinkat realloc reallocarray realpath remainder remove remquo rename renameat "
    "renameat2 revoke rewind rindex rint rmdir round roundeven rpmatch sbrk scalb scalbln scalbn scanf "
    "secure_getenv seed48 select setbuf setbuffer setdomainname setegid setenv seteuid setgid sethostid "
    "sethostname setjmp setlinebuf setlocale setlogin setpayload setpayloadsig setpgid setpgrp setregid "
    "setresgid setresuid setreuid setsid setstate setuid setusershell setvbuf sigaction sigaddset "
    "sigaltstack sigandset sigblock sigcontext sigdelset sigemptyset sigevent sigfillset siggetmask "
    "sighold sigignore siginterrupt sigisemptyset sigismember siglongjmp signal signgam significand "
    "sigorset sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigsetmask sigstack "
    "sigsuspend sigtimedwait sigval sigwait sigwaitinfo sin sincos sinh sleep snprintf sprintf sqrt srand "
    "srand48 srandom sscanf ssignal std stderr stdin stdout stpcpy stpncpy strcasecmp strcasestr strcat "
    "strchr strchrnul strcmp strcoll strcpy strcspn strdup strerror strfromd strfromf strfromf128 "
    "strfromf32 strfromf32x strfroml strfry strftime strlen strncasecmp strncat strncmp strncpy strndup "
    "strnlen strpbrk strptime strrchr strsep strsignal strspn strstr strtod strtof strtof128 strtof32 "
    "strtof32x strtok strtol strtold strtoq strtoul strtouq strverscmp strxfrm swab swprintf swscanf "
    "symlink symlinkat sync syncfs syscall sysconf system tan tanh tcgetpgrp tcsetpgrp tempnam tgamma "
    "tgkill time timegm timelocal timespec timeval timex timezone tm tmpfile tmpnam toascii tolower "
    "totalorder totalordermag toupper trunc truncate ttyname ttyslot tzname tzset u_char u_int u_long "
    "u_short ualarm ufromfp ufromfpx uint ulong ungetc ungetwc unix unlink unlinkat unlockpt unsetenv "
    "uselocale ushort usleep valloc vasprintf vdprintf vec3 vfork vfprintf vfscanf vfwprintf vfwscanf "
    "vhangup vprintf vscanf vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy "
    "wcrtomb wcscasecmp wcscat wcschr wcschrnul wcscmp wcscoll wcscpy wcscspn wcsdup wcsftime wcslen "
    "wcsncasecmp wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr "
    "wcstod wcstof wcstof128 wcstof32 wcstof32x wcstok wcstol wcstold wcstombs wcstoq wcstoul wcstouq "
    "wcswcs wcswidth wcsxfrm wctob wctomb wcwidth wmemchr wmemcmp wmemcpy wmemmove wmempcpy wmemset "
    "wprintf write wscanf y0 y1 yn zndev znroot";

// Reserved words of OSL, its types and global variables (chapters 4 to 6 of the specification), and the
// names that write_osl.cpp writes.
constexpr std::string_view kOsl =
    "Ci I M_PI N Ng P Ps T and bool break case catch char class closure color const continue dPdtime dPdu "
    "dPdv default delete diffuse displacement do double dtime else emit enum extern false float for "
    "friend goto if illuminance illuminate inline int light long matrix microfacet new normal normalize "
    "not operator or oren_nayar output phong point private protected public radians return rotate shader "
    "short signed sizeof static string struct surface switch template this throw time true try typedef u "
    "uniform union unsigned v varying vector virtual void volatile volume ward while";

// Words of GLSL and HLSL that are no words of C++, and the functions and variables that exported shaders use.
constexpr std::string_view kShaderWords =
    "AppendStructuredBuffer BRDF Buffer ByteAddressBuffer ConsumeStructuredBuffer INFINITY InputPatch L "
    "LineStream N NAN NULL OutputPatch PointStream RWBuffer RWByteAddressBuffer RWStructuredBuffer "
    "RWTexture1D RWTexture2D RWTexture3D SamplerState StructuredBuffer Texture1D Texture2D Texture3D "
    "TextureCube TriangleStream V X Y abs acos active all any asfloat asin asint asuint atan atan2 "
    "atomic_uint attribute buffer bvec2 bvec3 bvec4 cast cbuffer ceil centroid clamp clip coherent "
    "column_major common cos cosh cross ddx ddy degrees discard dmat2 dmat3 dmat4 dot double2 double3 "
    "double4 dvec2 dvec3 dvec4 dword exp exp2 external f16tof32 f32tof16 filter fixed flat float1 float2 "
    "float3 float4 floatBitsToUint floor fma fmod frac fract groupshared half half2 half3 half4 highp hvec2 "
    "hvec3 hvec4 iimage2D image2D in inout input int1 int2 int3 int4 interface invariant inverse "
    "inversesqrt isampler2D isinf isnan ivec2 ivec3 ivec4 layout length lerp linear line lineadj log log2 "
    "lowp mad main mat2 mat3 mat4 matrix max mediump min mix mod modf mul nointerpolation noise "
    "noperspective normalize out output packHalf2x16 packoffset partition pass patch pixelfragment "
    "pixelshader point pow precise precision radians rcp readonly reflect refract resource restrict round "
    "roundEven row_major rsqrt sample sampler sampler1D sampler2D sampler3D samplerCube sampler_state "
    "saturate shared sign sin sincos sinh smooth smoothstep snorm sqrt stateblock stateblock_state step "
    "string subroutine superp tan tanh tbuffer technique technique10 technique11 texture texture1D "
    "texture2D texture3D textureCube transpose triangle triangleadj trunc uimage2D uint uint1 uint2 uint3 "
    "uint4 uintBitsToFloat uniform unorm unpackHalf2x16 usampler2D uvec2 uvec3 uvec4 varying vec2 vec3 vec4 "
    "vector vertexfragment vertexshader wi wo writeonly";

bool has_word(std::string_view words, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = 0; (at = words.find(word, at)) != words.npos; at += word.size()) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

bool is_shout(std::string_view word) {
  return word.find('_') != word.npos &&
         std::ranges::none_of(word, [](char c) { return std::islower(static_cast<unsigned char>(c)); });
}

// Also covers sinf and sinf32x if sin is listed, types of POSIX (_t), variants of its functions, and names
// that look like macros.
bool is_taken_in_cpp(std::string_view word) {
  if (has_word(kCppKeywords, word) || has_word(kCppTaken, word)) return true;
  if (is_shout(word)) return true;
  for (const std::string_view begin :
       {"M_", "brdf_kernels_", "f32", "f64"})  // glibc declares f32addf64 and similar names
    if (word.starts_with(begin)) return true;
  for (const std::string_view end : {"_t", "_r", "_l", "_np"})
    if (word.ends_with(end)) return true;
  for (const std::string_view type : {"f", "l", "f16", "f32", "f32x", "f64", "f64x", "f128", "64", "64x"})
    if (word.ends_with(type) && word.size() > type.size() + 1 &&
        has_word(kCppTaken, word.substr(0, word.size() - type.size())))
      return true;
  return false;
}

bool is_taken_in_shaders(std::string_view word) {
  if (has_word(kCppKeywords, word) || has_word(kShaderWords, word)) return true;
  for (const std::string_view begin : {"M_", "brdf_", "gl_"})
    if (word.starts_with(begin)) return true;
  return false;
}

bool is_taken(std::string_view word, NameIn in) {
  switch (in) {
    case NameIn::file:
      return false;
    case NameIn::cpp:
      return is_taken_in_cpp(word);
    case NameIn::osl:
      return has_word(kOsl, word);
    case NameIn::argument:
      return is_taken_in_shaders(word);
  }
  return false;
}

// Replaces every character other than a letter or a digit by an underscore, and runs of underscores by one.
std::string with_plain_characters(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const char plain = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    if (plain != '_' || !out.ends_with('_')) out += plain;
  }
  return out;
}

}  // namespace

std::string identifier(const std::string& name, NameIn in) {
  const std::string plain = with_plain_characters(name);
  const std::string kind = in == NameIn::argument ? "argument" : "material";
  if (plain.empty() || plain == "_") return kind;
  if (plain[0] == '_') return kind + plain;
  return is_taken(plain, in) || std::isdigit(static_cast<unsigned char>(plain[0])) ? kind + "_" + plain
                                                                                   : plain;
}

}  // namespace brdf::io
