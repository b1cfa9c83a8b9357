package org.dronemap.ws.soap;

import org.apache.cxf.binding.soap.Soap11;
import org.apache.cxf.binding.soap.SoapMessage;
import org.apache.cxf.binding.soap.interceptor.AbstractSoapInterceptor;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.Phase;

/** Sets the SOAP version of a message from its media type, so that a fault before the envelope has the right one. */
final class SoapVersionInterceptor extends AbstractSoapInterceptor {
    SoapVersionInterceptor() {
        super(Phase.RECEIVE);
    }

    @Override
    public void handleMessage(SoapMessage message) {
        if (message.get(Message.CONTENT_TYPE) instanceof String type && type.startsWith("text/xml")) {
            message.setVersion(Soap11.getInstance());
        }
    }
}
