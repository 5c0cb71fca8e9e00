/** The address of the module, as bundlers give it of a file that they copy: for `load` of `tiepoint`. */
declare const address: string;
export default address;
