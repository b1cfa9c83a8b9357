/**
 * XML and JSON of SOAP: types, and each written as the other.
 *
 * <p>Enters: what a type of the description looks like in XML.
 *
 * <p>Never: operations.
 */
@NullMarked
package org.dronemap.ws.soap.xml;

import org.jspecify.annotations.NullMarked;
