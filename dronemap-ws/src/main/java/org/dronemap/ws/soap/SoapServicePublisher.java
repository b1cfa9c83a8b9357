package org.dronemap.ws.soap;

import org.apache.cxf.Bus;
import org.dronemap.ws.soap.description.SoapServices;
import org.jspecify.annotations.Nullable;

/** Publishes all SOAP services on the CXF bus, before the first call or WSDL request. Any thread. */
public final class SoapServicePublisher {
    private final Bus bus;
    private final SoapContract contract;
    private final SoapCallExecutor calls;
    private volatile @Nullable SoapServices published;

    public SoapServicePublisher(Bus bus, SoapContract contract, SoapCallExecutor calls) {
        this.bus = bus;
        this.contract = contract;
        this.calls = calls;
    }

    SoapServices services() {
        SoapServices services = published;
        return services == null ? publish() : services;
    }

    private synchronized SoapServices publish() {
        SoapServices services = published;
        if (services == null) {
            services = contract.services();
            services.services().keySet().forEach(name -> SoapEndpointFactory.publish(bus, name, calls));
            published = services;
        }
        return services;
    }
}
