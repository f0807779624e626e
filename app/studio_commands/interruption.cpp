#include "interruption.hpp"

#include <semaphore.h>

#include <cerrno>
#include <csignal>

namespace deixis::app {

namespace {

sem_t came;

/// A semaphore is what a handler may post.
void onEnd(int signal) {
    (void)std::signal(signal, SIG_DFL);
    sem_post(&came);
}

}  // namespace

Interruption::Interruption() {
    sem_init(&came, 0, 0);
    (void)std::signal(SIGINT, onEnd);
    (void)std::signal(SIGTERM, onEnd);
}

Interruption::~Interruption() {
    (void)std::signal(SIGINT, SIG_DFL);
    (void)std::signal(SIGTERM, SIG_DFL);
    sem_destroy(&came);
}

void Interruption::wait() const {
    while (sem_wait(&came) != 0 && errno == EINTR) {
    }
}

}  // namespace deixis::app
