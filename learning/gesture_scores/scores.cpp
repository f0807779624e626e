#include "learning/gesture_scores/scores.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace deixis::learning {

namespace {

Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& rows) {
    const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
    return centred.transpose() * centred / static_cast<double>(rows.rows() - 1);
}

}  // namespace

double GestureScores::score() const {
    if (!controls) return fgd_no_controls;
    return std::cbrt(pcs * scs * (fgd_no_controls + fgd_pose_controls + fgd_style_controls) / 3.0);
}

double frechetDistance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    const Eigen::MatrixXd of_a = covarianceOf(a), of_b = covarianceOf(b);
    // A B has the eigenvalues of the symmetric A^(1/2) B A^(1/2).
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(of_a);
    const Eigen::MatrixXd root = parts.eigenvectors() *
                                 parts.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                                 parts.eigenvectors().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> product(root * of_b * root, Eigen::EigenvaluesOnly);
    const double shared = product.eigenvalues().cwiseMax(0.0).cwiseSqrt().sum();
    const double apart = (a.colwise().mean() - b.colwise().mean()).squaredNorm();
    return std::max(0.0, apart + of_a.trace() + of_b.trace() - 2.0 * shared);
}

}  // namespace deixis::learning
