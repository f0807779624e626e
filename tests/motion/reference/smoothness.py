# Makes smoothness.csv: log dimensionless jerk and SPARC of a few movements, by NumPy's FFT and differences.
# Definitions: Balasubramanian et al. 2015, J. NeuroEng. Rehabil. 12:112; padding level 4, 10 Hz, threshold 0.05.
# Run: python3 smoothness.py > smoothness.csv (NumPy 1.24). A line: name,fps,ldlj,sparc,x,y,z,x,y,z,...
import numpy as np


def ldlj(positions, fps):
    velocity = np.diff(positions, axis=0) * fps
    jerk = np.diff(velocity, n=2, axis=0) * fps**2
    duration = len(velocity) / fps
    peak = np.linalg.norm(velocity, axis=1).max()
    return -np.log(duration**3 / peak**2 * (np.linalg.norm(jerk, axis=1) ** 2).sum() / fps)


def sparc(speed, fps):
    n = int(2 ** (np.ceil(np.log2(len(speed))) + 4))
    spectrum = np.abs(np.fft.rfft(speed, n))
    spectrum /= spectrum.max()
    f = np.fft.rfftfreq(n, 1 / fps)
    spectrum, f = spectrum[f <= 10], f[f <= 10]
    last = np.nonzero(spectrum >= 0.05)[0][-1]
    spectrum, f = spectrum[: last + 1], f[: last + 1]
    return -np.hypot(np.diff(f) / (f[-1] - f[0]), np.diff(spectrum)).sum()


def central_speed(positions, fps):
    half = max(1, round(fps / 30))
    i = np.arange(len(positions))
    before, after = np.maximum(i - half, 0), np.minimum(i + half, len(positions) - 1)
    return np.linalg.norm((positions[after] - positions[before]) * fps / (after - before)[:, None], axis=1)


def minimum_jerk(u):
    return 10 * u**3 - 15 * u**4 + 6 * u**5


random = np.random.default_rng(7)
movements = []
u = np.linspace(0, 1, 25)
movements.append(("one_reach_30", 30, np.outer(minimum_jerk(u), [0.3, 0.5, -0.2])))
two = np.concatenate([minimum_jerk(np.linspace(0, 1, 16)), 1 + 0.4 * minimum_jerk(np.linspace(0, 1, 16))[1:]])
movements.append(("two_strokes_30", 30, np.outer(two, [0.5, 0.1, 0.3])))
u = np.linspace(0, 1, 49)
wobble = np.outer(minimum_jerk(u), [0.4, 0.4, 0.1]) + 0.004 * random.standard_normal((49, 3))
movements.append(("shaky_60", 60, wobble))
u = np.linspace(0, 1, 20)
movements.append(("slow_sampling_15", 15, np.stack([0.6 * minimum_jerk(u), 0.1 * np.sin(np.pi * u), 0 * u], 1)))
for name, fps, p in movements:
    p = np.round(p, 6)
    values = [name, str(fps), f"{ldlj(p, fps):.9f}", f"{sparc(central_speed(p, fps), fps):.9f}"]
    print(",".join(values + [f"{x:g}" if abs(x) < 1e-12 else f"{x:.6f}" for x in p.flatten()]))
