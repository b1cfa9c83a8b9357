package org.dronemap.ws.wiring;

import jakarta.servlet.ServletContext;
import java.time.Clock;
import java.util.List;
import java.util.stream.Stream;
import org.apache.cxf.Bus;
import org.apache.cxf.bus.extension.ExtensionManagerBus;
import org.apache.cxf.transport.servlet.CXFNonSpringServlet;
import org.dronemap.ws.plainhttp.OriginalAddressFilter;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.soap.InProcessRestClient;
import org.dronemap.ws.soap.SoapAuthentication;
import org.dronemap.ws.soap.SoapCallExecutor;
import org.dronemap.ws.soap.SoapContract;
import org.dronemap.ws.soap.SoapResponseAdvice;
import org.dronemap.ws.soap.SoapServicePublisher;
import org.dronemap.ws.soap.UsernameTokenReader;
import org.dronemap.ws.soap.WsdlFilter;
import org.springframework.boot.web.servlet.FilterRegistrationBean;
import org.springframework.boot.web.servlet.ServletRegistrationBean;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.filter.OncePerRequestFilter;
import org.springframework.web.servlet.DispatcherServlet;

/** Spring configuration of the SOAP face, which is derived from the REST face. */
@Configuration(proxyBeanMethods = false)
class SoapConfiguration {
    private static final String DESCRIPTION = "/api/openapi.json";

    /** The one bus of this server; services appear on it when they are first asked for. */
    @Bean(destroyMethod = "shutdown")
    Bus soapBus() {
        return new ExtensionManagerBus();
    }

    /** A call passes the filters that judge and note requests; those that bound connections have seen it already. */
    @Bean
    InProcessRestClient restCalls(
            DispatcherServlet dispatcher,
            FilterRegistrationBean<OncePerRequestFilter> audit,
            FilterRegistrationBean<OncePerRequestFilter> plainAddress,
            FilterRegistrationBean<OncePerRequestFilter> access,
            ProblemWriter problems) {
        return new InProcessRestClient(
                dispatcher, List.of(audit.getFilter(), plainAddress.getFilter(), access.getFilter()), problems);
    }

    @Bean
    SoapContract soapContract(InProcessRestClient rest, JsonCodec json, ServletContext context) {
        return new SoapContract(() -> json.mapper().readTree(rest.read(context, DESCRIPTION)));
    }

    @Bean
    SoapCallExecutor soapCalls(
            SoapContract contract,
            InProcessRestClient rest,
            CallerAuthenticator authentication,
            Clock clock,
            JsonCodec json) {
        return new SoapCallExecutor(
                contract, new SoapAuthentication(authentication, new UsernameTokenReader(clock)), rest, json);
    }

    @Bean
    SoapResponseAdvice soapResponses() {
        return new SoapResponseAdvice();
    }

    @Bean
    SoapServicePublisher publishedServices(Bus soapBus, SoapContract contract, SoapCallExecutor calls) {
        return new SoapServicePublisher(soapBus, contract, calls);
    }

    @Bean
    FilterRegistrationBean<WsdlFilter> serviceDescriptions(
            SoapServicePublisher published, ProblemWriter problems, ServerSettings settings) {
        FilterRegistrationBean<WsdlFilter> registration =
                new FilterRegistrationBean<>(new WsdlFilter(published, problems));
        registration.addUrlPatterns("/services");
        registration.addUrlPatterns(paths(settings));
        return registration;
    }

    @Bean
    ServletRegistrationBean<CXFNonSpringServlet> soapServlet(Bus soapBus, ServerSettings settings) {
        CXFNonSpringServlet servlet = new CXFNonSpringServlet();
        servlet.setBus(soapBus);
        ServletRegistrationBean<CXFNonSpringServlet> registration =
                new ServletRegistrationBean<>(servlet, paths(settings));
        registration.setName("soap");
        registration.addInitParameter("hide-service-list-page", "true");
        return registration;
    }

    private static String[] paths(ServerSettings settings) {
        Stream<String> original =
                settings.originalAddresses() ? OriginalAddressFilter.paths().stream() : Stream.empty();
        return Stream.concat(Stream.of("/services/*"), original).toArray(String[]::new);
    }
}
