# rimpact on Debian 12: docker build -t rimpact . && docker run --rm -v "$PWD:/work" rimpact reduced ricker-0.78g-1.0s
FROM debian:12 AS build
COPY . /source
WORKDIR /source
RUN bash -c '. cmake/install.sh && install_missing' && cmake --preset package && cmake --build build/package \
  && cpack -G DEB --config build/package/CPackConfig.cmake -B /package

FROM debian:12
COPY --from=build /package/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["rimpact"]
CMD ["--help"]
