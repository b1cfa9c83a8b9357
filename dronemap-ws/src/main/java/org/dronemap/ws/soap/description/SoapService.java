package org.dronemap.ws.soap.description;

import java.util.List;
import java.util.Optional;

/**
 * One SOAP service, with its operations, as one WSDL describes it. {@code port} and {@code portType} are names there.
 */
public record SoapService(String name, String port, String portType, List<SoapOperation> operations) {
    public Optional<SoapOperation> operation(String name) {
        return operations.stream().filter(one -> one.name().equals(name)).findFirst();
    }
}
