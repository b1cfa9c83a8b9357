package org.dronemap.ws.soap;

import org.apache.cxf.binding.soap.Soap11;
import org.apache.cxf.binding.soap.SoapMessage;
import org.apache.cxf.binding.soap.interceptor.AbstractSoapInterceptor;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.Phase;

/** Takes the version of a message from its media type until its envelope is read: a fault may have to be told before that. */
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
