// SPDX-License-Identifier: BSD-3-Clause
#include "TetGen/TetGenProcess.h"

#include "TetGen/TetGenChannel.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <sstream>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interlume
{

namespace
{
/// Error messages quote at most this number of bytes from the end of TetGen's output.
constexpr long OutputTail = 400;
/// Error code of TetGen for insufficient memory.
constexpr int MemoryCode = 1;

/// Returns the path of the worker next to the library that contains this function.
std::string FindProgram()
{
  Dl_info info;
  if (::dladdr(reinterpret_cast<const void*>(&FindProgram), &info) == 0 || !info.dli_fname)
  {
    return std::string();
  }
  const std::string library = info.dli_fname;
  const std::size_t slash = library.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : library.substr(0, slash);
  return folder + "/" + INTERLUME_TETGEN_PROGRAM;
}

std::string Describe(int code)
{
  switch (code)
  {
    case MemoryCode:
      return "it ran out of memory";
    case 2:
      return "it encountered an internal error";
    case 3:
      return "two facets intersect";
    case 4:
      return "points or facets are too close to each other";
    case 5:
      return "two facets nearly coincide";
    case 10:
      return "it rejected the input";
    default:
      return "it reported error code " + std::to_string(code);
  }
}
}

TetGenProcess::TetGenProcess(const std::string& program)
  : Program(program.empty() ? FindProgram() : program)
{
}

TetGenProcess::~TetGenProcess()
{
  this->Stop();
}

Error TetGenProcess::Spawn(int workerSocket)
{
  const int outputFile = ::fileno(this->Output);
  ::fcntl(outputFile, F_SETFD, FD_CLOEXEC);
  posix_spawn_file_actions_t actions;
  int error = ::posix_spawn_file_actions_init(&actions);
  if (error == 0)
  {
    std::string program = this->Program;
    std::array<char*, 2> arguments{ { &program[0], nullptr } };
    error = ::posix_spawn_file_actions_adddup2(&actions, workerSocket, STDIN_FILENO) ||
        ::posix_spawn_file_actions_adddup2(&actions, outputFile, STDOUT_FILENO) ||
        ::posix_spawn_file_actions_adddup2(&actions, outputFile, STDERR_FILENO)
      ? ENOMEM
      : ::posix_spawn(
          &this->Process, program.c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
  }
  if (error == 0)
  {
    return {};
  }
  this->Process = -1;
  return Error("cannot start " + this->Program + ": " + std::strerror(error), ErrorCode::Process);
}

Error TetGenProcess::Start()
{
  std::array<int, 2> sockets{ { -1, -1 } };
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
  {
    return Error(
      std::string("cannot create a socket: ") + std::strerror(errno), ErrorCode::Process);
  }
  this->Socket = sockets[0];
  this->Output = std::tmpfile();
  Error error = this->Output
    ? this->Spawn(sockets[1])
    : Error(
        std::string("cannot create a temporary file: ") + std::strerror(errno), ErrorCode::File);
  ::close(sockets[1]);
  if (error)
  {
    this->Stop();
  }
  return error;
}

std::string TetGenProcess::Stop()
{
  std::string ending = "it returned an invalid result";
  if (this->Socket >= 0)
  {
    ::close(this->Socket);
    this->Socket = -1;
  }
  if (this->Process > 0)
  {
    // Check first whether the worker has crashed, to report its signal instead of SIGKILL.
    int status = 0;
    pid_t ended = ::waitpid(this->Process, &status, WNOHANG);
    if (ended == 0)
    {
      ::kill(this->Process, SIGKILL);
      do
      {
        ended = ::waitpid(this->Process, &status, 0);
      } while (ended < 0 && errno == EINTR);
    }
    if (ended == this->Process && WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL)
    {
      ending = "it crashed with signal " + std::to_string(WTERMSIG(status));
    }
    else if (ended == this->Process && WIFEXITED(status))
    {
      ending = "it ended with exit code " + std::to_string(WEXITSTATUS(status));
    }
    this->Process = -1;
  }
  if (this->Output)
  {
    std::fclose(this->Output);
    this->Output = nullptr;
  }
  return ending;
}

std::string TetGenProcess::GetLastOutput() const
{
  std::string text;
  if (this->Output && std::fseek(this->Output, 0, SEEK_END) == 0)
  {
    const long size = std::ftell(this->Output);
    const long start = size > OutputTail ? size - OutputTail : 0;
    text.resize(static_cast<std::size_t>(size - start));
    std::fseek(this->Output, start, SEEK_SET);
    text.resize(std::fread(&text[0], 1, text.size(), this->Output));
  }
  // Replace line breaks and other unprintable characters with spaces.
  std::string line;
  for (char c : text)
  {
    const bool isPrintable = std::isgraph(static_cast<unsigned char>(c)) != 0;
    if (isPrintable)
    {
      line += c;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  return line.empty() ? line : "; the end of its output: " + line;
}

Error TetGenProcess::Solve(const TetGenProblem& problem, TetGenSolution& solution)
{
  using Clock = std::chrono::steady_clock;
  this->TimedOut = false;
  if (Error error = this->Socket < 0 ? this->Start() : Error())
  {
    return error;
  }
  const Clock::time_point start = Clock::now();
  bool canceled = false;
  const auto mayWait = [&]()
  {
    canceled = this->IsCanceled && this->IsCanceled();
    this->TimedOut = this->TimeLimit > 0.0 &&
      std::chrono::duration<double>(Clock::now() - start).count() > this->TimeLimit;
    return !canceled && !this->TimedOut;
  };
  TetGenChannel channel(this->Socket, mayWait);
  const bool hasSolution = channel.Send(problem) && channel.Receive(solution);
  if (hasSolution && solution.Code == 0)
  {
    return {};
  }
  const std::string output = this->GetLastOutput();
  const std::string ending = this->Stop();
  if (canceled)
  {
    return {};
  }
  std::ostringstream message;
  message << "TetGen failed: ";
  if (this->TimedOut)
  {
    message << "it was not done after " << this->TimeLimit << " s (TimeLimit)";
  }
  else
  {
    message << (hasSolution ? Describe(solution.Code) : ending);
  }
  message << output;
  return Error(message.str(),
    hasSolution && solution.Code == MemoryCode ? ErrorCode::OutOfMemory : ErrorCode::Process);
}

}
