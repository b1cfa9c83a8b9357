package org.dronemap.ws.soap;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.xml.ws.Provider;
import jakarta.xml.ws.Service;
import jakarta.xml.ws.ServiceMode;
import jakarta.xml.ws.WebServiceProvider;
import javax.xml.transform.Source;
import javax.xml.transform.dom.DOMSource;
import org.apache.cxf.continuations.Continuation;
import org.apache.cxf.continuations.ContinuationProvider;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.PhaseInterceptorChain;
import org.apache.cxf.transport.http.AbstractHTTPDestination;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * CXF provider of one SOAP service, which hands each call to {@link SoapCallExecutor}. Any thread; a call that waits
 * for an outcome holds none.
 */
@WebServiceProvider
@ServiceMode(Service.Mode.PAYLOAD)
public final class SoapServiceProvider implements Provider<Source> {
    /** Longer than REST lets anybody wait. */
    private static final long LONGEST_WAIT_MILLIS = 90_000;

    private final String service;
    private final SoapCallExecutor calls;

    public SoapServiceProvider(String service, SoapCallExecutor calls) {
        this.service = service;
        this.calls = calls;
    }

    /** Null: the call waits, and this is asked again when its answer is there. */
    @Override
    public @Nullable Source invoke(Source call) {
        Message message = PhaseInterceptorChain.getCurrentMessage();
        Continuation continuation = message.get(ContinuationProvider.class).getContinuation();
        if (continuation.getObject() instanceof SoapCallExecutor.Called called) {
            return calls.answer(called);
        }
        if (!(message.get(AbstractHTTPDestination.HTTP_REQUEST) instanceof HttpServletRequest request)) {
            throw new IllegalStateException("a SOAP call came without an HTTP request");
        }
        SoapCallExecutor.Called called = calls.begin(service, payload(call), message, request);
        if (called.answer().isDone()) {
            return calls.answer(called);
        }
        continuation.setObject(called);
        continuation.suspend(LONGEST_WAIT_MILLIS);
        var unused = called.answer().thenRun(continuation::resume);
        return null;
    }

    private static @Nullable Element payload(@Nullable Source call) {
        Node node = call instanceof DOMSource dom ? dom.getNode() : null;
        if (node instanceof Document document) {
            return document.getDocumentElement();
        }
        return node instanceof Element element ? element : null;
    }
}
