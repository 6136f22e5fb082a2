"""Fog, smoke and steam modelled as Gaussians, lit inside scenes.

    import brume
    scene = brume.load("scene.brume")
    frame = brume.render(scene, size=(800, 600), max_error=0.02)
    frame.save("frame.exr")

Lengths are in the scene's unit u, angles in degrees, times in seconds; colours are linear RGB.
"""

from ._brume import (
    Camera,
    DomainError,
    Environment,
    ErrorEstimate,
    Frame,
    InputError,
    Light,
    Medium,
    Renderer,
    Scene,
    Sky,
    Surface,
    __version__,
    fit,
    load,
    load_medium,
    render,
)

__all__ = [
    "Camera",
    "DomainError",
    "Environment",
    "ErrorEstimate",
    "Frame",
    "InputError",
    "Light",
    "Medium",
    "Renderer",
    "Scene",
    "Sky",
    "Surface",
    "fit",
    "load",
    "load_medium",
    "render",
]
