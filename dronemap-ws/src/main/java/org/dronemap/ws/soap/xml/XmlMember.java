package org.dronemap.ws.soap.xml;

/**
 * A child element of an XML type in SOAP: its name and type, and whether it is required or nullable.
 *
 * @param required it is always there
 * @param nullable it may be without a value
 * @param words what it means, for who reads the description; may be empty
 */
public record XmlMember(String name, XmlType type, boolean required, boolean nullable, String words) {}
