package org.dronemap.ws.soap;

/** The XML namespace of the service. */
final class Namespace {
    static final String URI = "http://cloud.dronemap.org/wsdl";

    private Namespace() {}
}
