package org.dronemap.ws.soap;

import java.util.Set;
import javax.xml.namespace.QName;
import org.apache.cxf.binding.soap.SoapMessage;
import org.apache.cxf.binding.soap.interceptor.AbstractSoapInterceptor;
import org.apache.cxf.phase.Phase;
import org.dronemap.ws.soap.xml.SoapNamespaces;

/** Declares SOAP headers with credentials as understood, so that clients may mark them mustUnderstand. */
final class CredentialHeaderInterceptor extends AbstractSoapInterceptor {
    CredentialHeaderInterceptor() {
        super(Phase.PRE_PROTOCOL);
    }

    @Override
    public Set<QName> getUnderstoodHeaders() {
        return Set.of(new QName(UsernameTokenReader.SECURITY, "Security"), new QName(SoapNamespaces.URI, "accessKey"));
    }

    @Override
    public void handleMessage(SoapMessage message) {
        // They are read when it has to be known who calls.
    }
}
