#include "app/console/interrupts.h"

#include "io/files/error.h"
#include <csignal>
#include <unistd.h>

namespace rimpact::app {
namespace {

std::atomic<bool> interrupt_flag{false}, interrupts_watched{false};

void on_interrupt(int) {
  if (!interrupts_watched || interrupt_flag) _exit(static_cast<int>(ExitCode::interrupted));
  interrupt_flag = true;
}

} // namespace

void catch_interrupts() {
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow fails to be written, with a sentence
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGHUP})
    if (std::signal(signal, on_interrupt) == SIG_IGN && signal == SIGHUP) std::signal(signal, SIG_IGN);
}

const std::atomic<bool> &interrupted() {
  return interrupt_flag;
}

void watch_interrupts() {
  interrupts_watched = true;
}

} // namespace rimpact::app
