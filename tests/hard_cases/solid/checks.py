"""What a hard case may ask of its run's summary; `of` gives the summary of another case by its name."""


def close_to(name, within):
    """Peak force against another case's."""
    return lambda s, of: abs(s["peak_impact_force_N"] / of(name)["peak_impact_force_N"] - 1) < within


def impacts(at_least):
    return lambda s, of: len(s["impacts"]) >= at_least
