# SPDX-License-Identifier: BSD-3-Clause
"""The report of the last execution of a filter or mapper as a dictionary."""


def report(algorithm):
    """Returns the values of the algorithm's GetReport() by name.

    A value is a number or a string, or a tuple of them if it does not have exactly one entry.
    """
    try:
        values = algorithm.GetReport()
    except AttributeError:
        raise TypeError(f"{algorithm.GetClassName()} has no report") from None
    arrays = [values.GetAbstractArray(i) for i in range(values.GetNumberOfArrays())]
    return {array.GetName(): _read(array) for array in arrays}


def _read(array):
    entries = tuple(array.GetValue(i) for i in range(array.GetNumberOfValues()))
    return entries[0] if len(entries) == 1 else entries
