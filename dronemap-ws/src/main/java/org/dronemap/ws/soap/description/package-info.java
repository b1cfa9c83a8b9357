/**
 * Services, operations and types of SOAP, made from the description of REST.
 *
 * <p>Enters: what WSDL says.
 *
 * <p>Never: calls.
 */
@NullMarked
package org.dronemap.ws.soap.description;

import org.jspecify.annotations.NullMarked;
