// Which of OpenBLAS's kernels multiply matrices for LibTorch.
#pragma once

namespace deixis::app {

/// Starts the program anew, with the same arguments, where OPENBLAS_CORETYPE does not name a kind of
/// processor: with one that has this processor's widest vectors. OpenBLAS goes by the processors' names, and
/// on one that is newer than itself takes kernels of 2004, by which a training takes 2.5 times as long; and
/// it looks only when a program starts. Returns where there is nothing to be done, or nothing can be.
void restartWithFastBlas();

}  // namespace deixis::app
