package org.dronemap.ws.soap.xml;

/** The XML namespaces of the SOAP services and their types. */
public final class SoapNamespaces {
    /** Of services and operations. */
    public static final String URI = "http://cloud.dronemap.org/wsdl";

    /** Of the types that they take and answer with. Its number changes when programs made from an earlier one would no longer do. */
    public static final String TYPES = "http://cloud.dronemap.org/types/2";

    private SoapNamespaces() {}
}
