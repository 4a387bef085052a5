# rimpact in a container, on Debian 12 or by --build-arg SYSTEM=debian:13: docker build -t rimpact . && docker run --rm -v "$PWD:/work" rimpact reduced ricker-0.78g-1.0s
ARG SYSTEM=debian:12
FROM ${SYSTEM} AS build
COPY . /source
WORKDIR /source
RUN bash -c '. cmake/install.sh && install_missing' && cmake --preset package && cmake --build build/package \
  && cpack -G DEB --config build/package/CPackConfig.cmake -B /package

FROM ${SYSTEM}
COPY --from=build /package/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["rimpact"]
CMD ["--help"]
