"""How a cost grows with the size of a scan."""
import math


def power_law(points):
    """factor and exponent of the cost = factor * size ** exponent that comes closest to the
    (size, cost) `points` by least squares of the logarithms. All are above 0, two sizes differ."""
    logs = [(math.log(size), math.log(cost)) for size, cost in points]
    x = sum(a for a, _ in logs) / len(logs)
    y = sum(b for _, b in logs) / len(logs)
    exponent = sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, _ in logs)
    return math.exp(y - exponent * x), exponent
