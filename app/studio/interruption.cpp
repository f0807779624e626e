#include "app/studio/interruption.hpp"

#include <semaphore.h>

#include <cerrno>
#include <csignal>

namespace deixis::app {

namespace {

sem_t pending;

/// A semaphore is what a handler may post.
void onEnd(int signal) {
    (void)std::signal(signal, SIG_DFL);
    sem_post(&pending);
}

}  // namespace

Interruption::Interruption() {
    sem_init(&pending, 0, 0);
    (void)std::signal(SIGINT, onEnd);
    (void)std::signal(SIGTERM, onEnd);
}

Interruption::~Interruption() {
    (void)std::signal(SIGINT, SIG_DFL);
    (void)std::signal(SIGTERM, SIG_DFL);
    sem_destroy(&pending);
}

void Interruption::wait() const {
    while (sem_wait(&pending) != 0 && errno == EINTR) {
    }
}

bool Interruption::came() const {
    return sem_trywait(&pending) == 0;
}

}  // namespace deixis::app
