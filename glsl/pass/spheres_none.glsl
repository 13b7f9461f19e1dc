// A scene without `//@ spheres`.
