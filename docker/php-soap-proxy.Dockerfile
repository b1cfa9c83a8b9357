# The PHP SOAP proxy with its page on Apache. Build it from the checkout:
#   docker build -f docker/php-soap-proxy.Dockerfile -t dronemap-php .
#   docker run --rm -p 127.0.0.1:8083:8080 -e DRONEMAP_PHP_SERVER=http://SERVER:8080 dronemap-php
# It speaks plain HTTP: publish it on loopback, or put a web server with TLS before it.
FROM debian:bookworm-slim

RUN apt-get update \
    && apt-get install -y --no-install-recommends apache2 ca-certificates curl libapache2-mod-php php-soap php-xml \
    && rm -rf /var/lib/apt/lists/* \
    && a2dismod -q status \
    && echo 'Listen 8080' > /etc/apache2/ports.conf

COPY php-soap-proxy /opt/php-soap-proxy
COPY docker/php-soap-proxy.conf /etc/apache2/sites-available/000-default.conf

ENV DRONEMAP_PHP_SERVER=http://server:8080
EXPOSE 8080/tcp
HEALTHCHECK --interval=15s --timeout=5s CMD ["curl", "--fail", "--silent", "--output", "/dev/null", "http://127.0.0.1:8080/"]
STOPSIGNAL SIGWINCH
CMD ["apachectl", "-D", "FOREGROUND"]
